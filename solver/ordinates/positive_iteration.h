// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/ordinates/iteration.h"

namespace etendue {

/// Vectors that Anderson acceleration keeps.
inline constexpr std::size_t anderson_memory = 4;

/// The fixed point of a sweep that keeps values positive (TransportSweep::keep_positive), which is not
/// affine: fixed-point iteration with Anderson acceleration (Anderson 1965; Walker and Ni 2011, type II),
/// each band by itself. Meant to start from the solution of the linear problem, so that little is left to do.
/// The next state is clipped at zero, which takes it nearer to the fixed point, since that is not negative.
/// The error is estimated as |r| / (s |phi|), with s the smallest |change of r| / |change of x| seen.
class PositiveIteration : public Iteration {
 public:
  const char* name() const override { return "anderson"; }
  IterationResult run(TransportSweep& sweep, TransportState& state, const IterationOptions& options,
                      const SolveObserver& observer) override;
};

}  // namespace etendue
