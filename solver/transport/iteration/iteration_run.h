// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <span>
#include <string_view>

#include "solver/transport/iteration/band_vectors.h"
#include "solver/transport/iteration/iteration.h"

namespace etendue {

/// Relative residuals below this are rounding.
inline constexpr double smallest_residual = 1e-15;

/// One run of an iteration: the part that all of them share. It lets the iteration step until all bands have
/// converged, the sweeps are used up or the observer stops it; it counts sweeps, keeps the history, reports
/// progress and checks that all numbers are finite.
class IterationRun {
 public:
  /// The arguments must outlive it.
  IterationRun(TransportSweep& sweep, TransportState& state, const IterationOptions& options,
               const SolveObserver& observer);
  virtual ~IterationRun() = default;
  IterationRun(const IterationRun&) = delete;
  IterationRun& operator=(const IterationRun&) = delete;

  /// Runs once. Throws NotFiniteError; and SweepStopped, with the best state so far in the state.
  IterationResult run();

 protected:
  /// Improves the state by one or more sweeps, and reports each.
  virtual void step() = 0;
  /// Seconds until the tolerance is met, from the progress in the seconds so far; negative: unknown.
  virtual double seconds_left(double seconds) = 0;
  /// Copy of the best state so far.
  virtual SavedState best_state() const;
  /// Brings the best state so far into the state, after the last step.
  virtual void finish() {}
  /// The same where a sweep was stopped in its midst.
  virtual void abandon() {}

  int sweeps_left() const { return options_.max_sweeps - result_.sweeps; }
  bool all_converged() const;
  /// [band] estimated relative errors.
  std::vector<double> errors() const;
  /// Checks the state that the last sweep gave.
  void check(const TransportState& state) const;
  /// Checks sizes [band] of a quantity with a name, such as "residual".
  void check(std::string_view quantity, std::span<const double> sizes) const;
  /// Sets the convergence of a band that took part in the last sweep, and adds a line to the history.
  void record(std::size_t band, const BandConvergence& convergence);
  /// Reports progress after a sweep. Returns false where the observer stops the iteration.
  bool report();
  /// Makes this step the last.
  void end() { ended_ = true; }

  TransportSweep& sweep_;
  TransportState& state_;
  const IterationOptions& options_;
  BandVectors vectors_;
  std::size_t bands_;
  IterationResult result_;

 private:
  const SolveObserver& observer_;
  bool ended_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace etendue
