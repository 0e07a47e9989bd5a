// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <complex>
#include <functional>
#include <span>
#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/solution/solution.h"
#include "solver/solution/solve_observer.h"
#include "solver/solution/solve_options.h"
#include "solver/time/laplace_problem.h"
#include "solver/time/uncollided_in_time.h"

namespace etendue {

/// Solutions of neighbouring rates.
struct SolvedRates {
  std::size_t first = 0;  ///< number of the first rate
  std::size_t count = 0;
  const Problem& problem;    ///< of these rates: LaplaceProblem::problem
  const Solution& solution;  ///< of it; means over the sets
  /// Uncollided light of these rates, which is not in the solution; null where all is.
  const UncollidedValues* uncollided = nullptr;
};

/// Takes solutions while they last. Returns false where no more are wanted.
using SolvedRatesReader = std::function<bool(const SolvedRates&)>;

/// Number of rates, of so many, that solve_laplace() solves side by side: with more of them a sweep is
/// cheaper, but the iteration has less memory for its vectors.
std::size_t rates_side_by_side(const Problem& problem, const DirectionSet& directions, std::size_t rates,
                               const SolveOptions& options);

/// Solves laplace_problem() for all rates, some of them side by side, in their order. Options as of a steady
/// solution, with meters; an angular input, a state to start from and ordinates to keep are not used. Light
/// that `uncollided` knows is not swept until it has collided; null: all is left to the directions. Throws as
/// laplace_problem() and solve() do.
void solve_laplace(const Problem& problem, const std::vector<DirectionSet>& sets,
                   std::span<const std::complex<double>> rates, const Slowness& slowness,
                   const SolveOptions& options, const SolvedRatesReader& reader,
                   const SolveObserver& observer = {}, const UncollidedInTime* uncollided = nullptr);

}  // namespace etendue
