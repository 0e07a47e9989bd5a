// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/solution/solution.h"
#include "solver/solution/solve_observer.h"
#include "solver/transport/state/transport_state.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {

class CoarseDirections;
class DiffusionAcceleration;

struct IterationOptions {
  double tolerance = 1e-6;  ///< estimated relative error, per band
  int max_sweeps = 500;
  DiffusionAcceleration* acceleration = nullptr;  ///< null: none
  /// Estimate of the error where nothing is accelerated; null: the iteration's own estimate, which is too
  /// small in thick media.
  DiffusionAcceleration* judge = nullptr;
  /// The same sweep in single precision, for the cycles of GMRES. Null: none.
  SingleTransportSweep* single = nullptr;
  /// A sweep of fewer directions on which GMRES corrects its vectors, as long as that pays. Null: none.
  CoarseDirections* coarse = nullptr;
  /// Ends GMRES where the estimate of a cycle meets the tolerance, without a sweep that confirms it: then
  /// `converged` is an estimate too.
  bool trusts_estimate = false;
  /// Filled, where it is not null, by a sweep that is expected to be the last (IterationResult::recorded).
  SweepRecord* record = nullptr;
};

/// How an iteration ended.
struct IterationResult {
  std::vector<BandConvergence> bands;
  std::vector<HistoryEntry> history;  ///< of the bands that took part in each sweep
  std::vector<std::string> notes;     ///< for the user
  int sweeps = 0;                     ///< over all bands; those of a band end when it is done
  bool interrupted = false;
  bool recorded = false;  ///< the record belongs to the last sweep, which gave the state
};

/// A way to the fixed point of the sweep.
class Iteration {
 public:
  virtual ~Iteration() = default;
  virtual const char* name() const = 0;
  /// Whether it fills IterationOptions::record.
  virtual bool records() const { return false; }
  /// Improves `state` until the tolerance is met, the sweeps are used up or the observer stops it. Where a
  /// sweep throws SweepStopped, so does this, and `state` is the best so far.
  virtual IterationResult run(TransportSweep& sweep, TransportState& state, const IterationOptions& options,
                              const SolveObserver& observer) = 0;
};

}  // namespace etendue
