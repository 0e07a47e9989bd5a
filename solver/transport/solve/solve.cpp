// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/solve/solve.h"

#include "base/wall_clock.h"
#include "solver/transport/solve/transport_solver.h"

namespace etendue {

Solution solve(const Problem& problem, const DirectionSet& directions, const SolveOptions& options,
               const SolveObserver& observer) {
  const WallClock::time_point begun = WallClock::now();
  TransportSolver solver(problem, directions, options);
  const double setup = seconds_since(begun);
  Solution solution = solver.solve(observer);
  solution.seconds.setup = setup - solution.seconds.orders;
  return solution;
}

}  // namespace etendue
