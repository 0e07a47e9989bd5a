// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/solution/solve_observer.h"
#include "solver/uncollided/first_collision/solve_split.h"

namespace etendue {

/// The mean of the solutions on several sets, which differ in nothing but their rotation: the remaining ray
/// effects falls as one over the square root of their number, and how the solutions differ tells how much it
/// is (Solution::direction_error). Each starts from the one before. Radiance of ordinates is not kept.
/// `sets` is not empty; with one set this is solve_split(). Light that collides once is swept on the sets
/// `first_collided`, one for each of the others, or none.
Solution solve_rotated(const LightSetup& lights, const std::vector<DirectionSet>& sets,
                       const SolveOptions& options, const SolveObserver& observer = {},
                       const std::vector<DirectionSet>& first_collided = {},
                       const DirectionSetObserver& reader = {});

/// The same with uncollided light that was found before, which is handed over to the solution.
Solution solve_rotated(UncollidedLight& uncollided, const std::vector<DirectionSet>& sets,
                       const SolveOptions& options, const SolveObserver& observer = {},
                       const std::vector<DirectionSet>& first_collided = {},
                       const DirectionSetObserver& reader = {});

/// Root mean square over the volume of direction_error over that of the fluence, in the band where it is
/// most.
double relative_direction_error(const TetrahedralMesh& mesh, const Solution& solution);

/// Bytes that solve_rotated() takes at its peak.
std::size_t estimate_rotated_memory(const LightSetup& lights, const std::vector<DirectionSet>& sets,
                                    const SolveOptions& options,
                                    const std::vector<DirectionSet>& first_collided = {},
                                    KrylovVectors vectors = KrylovVectors::all);

}  // namespace etendue
