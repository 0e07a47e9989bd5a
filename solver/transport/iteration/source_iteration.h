// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/solution/solve_observer.h"
#include "solver/transport/iteration/iteration.h"

namespace etendue {

/// x <- F(x): every sweep scatters and reflects once more; or x <- x + P (F(x) - x). With the true residual r
/// of the iterate the error is estimated as |P r| / |phi|, or, where there is no P, as |r| / ((1 - rho)
/// |phi|), equation (14) of docs/theory/theory.md, with the measured rate of convergence rho.
class SourceIteration : public Iteration {
 public:
  const char* name() const override { return "source-iteration"; }
  IterationResult run(TransportSweep& sweep, TransportState& state, const IterationOptions& options,
                      const SolveObserver& observer) override;
};

/// Rate of convergence of one band from its last residuals.
class RateEstimate {
 public:
  /// Takes the next relative residual; gives the estimated relative error.
  double error(double residual);
  /// Sweeps until the error falls below `tolerance`; negative while unknown.
  double sweeps_left(double tolerance) const;

 private:
  std::vector<double> residuals_;
  double error_ = 0;
  double rate_ = 1;
};

}  // namespace etendue
