// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/lights/light_setup.h"
#include "solver/ordinates/solve.h"

namespace etendue {

/// Solves a problem as the sum of the light that has not collided yet, by rays, and the rest, by discrete
/// ordinates with the first collisions as a source. Without lights this is solve(). The options must not have
/// an angular input of their own.
Solution solve_split(const LightSetup& lights, const DirectionSet& directions, const SolveOptions& options,
                     const SolveObserver& observer = {});

/// Bytes that solve_split() may take at its peak: an upper estimate.
std::size_t estimate_split_memory(const LightSetup& lights, const DirectionSet& directions,
                                  const SolveOptions& options);

}  // namespace etendue
