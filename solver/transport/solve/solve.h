// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>

#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/solution/solution.h"
#include "solver/solution/solve_observer.h"
#include "solver/solution/solve_options.h"

namespace etendue {

/// How many vectors of GMRES an estimate of memory counts.
enum class KrylovVectors {
  typical,  ///< as many as most runs need: the expected peak
  all       ///< as many as one cycle may have: an upper estimate
};

/// Bytes that solve() takes at its peak, the solution included.
std::size_t estimate_memory(const Problem& problem, const DirectionSet& directions,
                            const SolveOptions& options, KrylovVectors vectors = KrylovVectors::all);

/// Vectors that a cycle of GMRES in solve() may have: more of them do not fit into its memory, or are no use.
double longest_cycle(const Problem& problem, const DirectionSet& directions, const SolveOptions& options);

/// Solves by discrete ordinates with upwind discontinuous Galerkin elements. Not converging is a result,
/// marked in the solution. Throws InputError where a mirror has no partner ordinates.
Solution solve(const Problem& problem, const DirectionSet& directions, const SolveOptions& options,
               const SolveObserver& observer = {});

}  // namespace etendue
