// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include "solver/solution/solution.h"
#include "solver/solution/solve_observer.h"
#include "solver/transport/acceleration/coarse_directions.h"
#include "solver/transport/iteration/iteration.h"
#include "solver/transport/solve/acceleration_policy.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {

/// Sweeps and options of one call of solve().
struct IterationSetup {
  TransportSweep& sweep;
  SingleTransportSweep* single;  ///< the same in single precision, for cycles of GMRES; null: none
  CoarseDirections* coarse;      ///< fewer directions, for corrections; null: none
  const LowOrder& low_order;
  const SolveOptions& options;
  const SolveObserver& observer;
};

std::unique_ptr<Iteration> make_iteration(Method method);

/// Name of a method in results.
const char* iteration_name(Method method);

/// Solves x = F(x) (docs/theory/theory.md, section 7): brings the state to the solution, fills the record by
/// the last sweep, and sets convergence, history and notes of the solution. Throws NotFiniteError; and
/// SweepStopped, with the best state so far in `state`.
void iterate(const IterationSetup& setup, TransportState& state, SweepRecord& record, Solution& solution);

}  // namespace etendue
