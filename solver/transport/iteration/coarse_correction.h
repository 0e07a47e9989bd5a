// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "solver/transport/acceleration/coarse_directions.h"
#include "solver/transport/acceleration/diffusion_acceleration.h"
#include "solver/transport/iteration/band_vectors.h"
#include "solver/transport/iteration/krylov_spaces.h"

namespace etendue {

/// Finds the z of P (I - T) z = v, to a part of v, with a T of fewer directions: GMRES within GMRES, (T1) to
/// (T3) of docs/theory/iteration.md. It is given up where it does not pay.
class CoarseCorrection {
 public:
  /// Longest Krylov basis, in states of the finer directions.
  static constexpr std::size_t longest_basis = 5;

  /// The arguments must outlive it; P is the identity where `acceleration` is null. `cost` is that of a sweep
  /// on the fewer directions, in sweeps on all of them.
  CoarseCorrection(CoarseDirections& coarse, DiffusionAcceleration* acceleration, const BandVectors& vectors,
                   double cost);

  /// Returns z, with a residual of `part` of v or, where the basis ends before, more. Bands that are not
  /// active stay out.
  TransportState solve(const TransportState& v, double part, const std::vector<char>& active);
  /// Takes the residuals [band] around the sweep on all directions that followed solve(), and gives up where
  /// sweeps alone would have got further for what both cost.
  void judge(const BandScalars& before, const BandScalars& after, const std::vector<char>& active);

  bool is_given_up() const { return given_up_; }
  /// Of P (I - T) in a band, between rounding and 1: the smallest that was seen.
  double smallest_singular_value(std::size_t band) const { return smallest_[band]; }

 private:
  /// Returns whether all numbers are finite.
  bool extend(const std::vector<char>& active);

  CoarseDirections& coarse_;
  DiffusionAcceleration* acceleration_;
  const BandVectors& vectors_;
  double cost_;
  KrylovSpaces spaces_;
  std::size_t sweeps_ = 0;  ///< of the last solve()
  BandScalars parts_;       ///< [band] of v that it left
  BandScalars smallest_;    ///< [band] singular value
  int vain_ = 0;            ///< corrections that did not pay, one after the other
  bool given_up_ = false;
};

}  // namespace etendue
