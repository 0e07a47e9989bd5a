// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/solution/solve_observer.h"
#include "solver/transport/iteration/iteration.h"

namespace etendue {

/// Bytes that the Krylov vectors may take, and most of them between restarts.
inline constexpr std::size_t krylov_memory = std::size_t{2} << 30;
inline constexpr std::size_t longest_krylov_basis = 50;
inline constexpr std::size_t shortest_krylov_basis = 3;

/// Restarted GMRES (Saad and Schultz 1986) on P (I - T) x = P b, where the sweep is F(x) = T x + b and x
/// holds moments, wall irradiance, mirrored and lagged traces. One application of T is one sweep; every band
/// has a Krylov space of its own, all are swept together. With acceleration by diffusion, P, the error is
/// estimated as |P r| / |phi|, (D6) of docs/theory/iteration.md, r = F(x) - x being the true residual. So it
/// is without, where P only judges; and where there is no P, as |r| / (s |phi|) with s the smallest singular
/// value of I - T seen on the Krylov spaces, equation (14) of docs/theory/theory.md (1 - rho for source
/// iteration).
///
/// With a sweep in single precision (IterationOptions::single) the cycles apply that one, and so correct a
/// residual that is found in double precision: iterative refinement (Wilkinson 1963; Carson and Higham 2018).
/// With a sweep of fewer directions (IterationOptions::coarse) each basis vector is corrected on them first,
/// as in flexible GMRES (Saad 1993), until that does not pay.
class Gmres : public Iteration {
 public:
  /// `memory` bounds the bytes of the basis and so the length between restarts.
  explicit Gmres(std::size_t memory = krylov_memory) : memory_(memory) {}
  const char* name() const override { return "gmres"; }
  /// Its last sweep shows the true residual and is recorded.
  bool records() const override { return true; }
  IterationResult run(TransportSweep& sweep, TransportState& state, const IterationOptions& options,
                      const SolveObserver& observer) override;

 private:
  std::size_t memory_;
};

}  // namespace etendue
