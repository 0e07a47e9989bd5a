// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/solution/solve_options.h"
#include "solver/transport/acceleration/coarse_directions.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {

/// Number of the fewer directions.
inline constexpr int coarsest_directions = 128;

/// Fewer directions for corrections of a solution on these: at most a sixth of them. None where the options
/// exclude them, there are too few, or light returns so often that single precision would not do.
std::optional<DirectionSet> coarser_directions(const Problem& problem, const DirectionSet& directions,
                                               const SolveOptions& options);

/// Their sweep. Null also where nothing is iterated, or light is scattered by a matrix, or passed on to the
/// next sweep by ordinates: by glossy walls and mirrors that face each other. `sweep` must outlive it.
std::unique_ptr<CoarseDirections> make_coarse_directions(const TransportSweep& sweep,
                                                         const SolveOptions& options);

}  // namespace etendue
