// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>

#include "solver/solution/solve_observer.h"
#include "solver/transport/iteration/iteration.h"

namespace etendue {

/// Steps of the past that Anderson acceleration keeps, two states each, in as many bytes as Krylov vectors
/// may take.
inline constexpr std::size_t longest_anderson_memory = 20;
inline constexpr std::size_t shortest_anderson_memory = 4;
/// For states of so many doubles.
std::size_t anderson_memory(double state_size);

/// The fixed point of a sweep that keeps values positive (TransportSweep::keep_positive), which is not
/// affine: fixed-point iteration x <- x + P (F(x) - x), P that of diffusion where there is one, with Anderson
/// acceleration (Anderson 1965; Walker and Ni 2011, type II), each band alone. Meant to start from the
/// solution of the linear problem, so that little is left to do. The next state is clipped at zero, which
/// takes it nearer to the fixed point, since that is not negative. The error is estimated as |P r| / (s
/// |phi|), with s the smallest |change of P r| / |change of x| seen.
class PositiveIteration : public Iteration {
 public:
  const char* name() const override { return "anderson"; }
  IterationResult run(TransportSweep& sweep, TransportState& state, const IterationOptions& options,
                      const SolveObserver& observer) override;
};

}  // namespace etendue
