// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/transport/state/transport_state.h"
#include "solver/transport/sweep/transport_sweep.h"

namespace etendue {

/// One number for each band.
using BandScalars = std::vector<double>;

/// Linear algebra on states, each band alone: bands are separate linear systems that are swept together. The
/// two bands of a complex radiance are one system, and have the sums of both as their inner products.
/// The inner product weights nodal values by their share of volume or wall area. Sums run over blocks of
/// fixed size in their order: the same bits for any number of threads.
class BandVectors {
 public:
  BandVectors(const TetrahedralMesh& mesh, const TransportSweep& sweep);

  BandScalars dot(const TransportState& a, const TransportState& b) const;
  /// The inner product of factor a and factor b.
  BandScalars dot(const TransportState& a, const TransportState& b, const BandScalars& factor) const;
  /// Of values of any size, those whose squares leave the range of numbers included.
  BandScalars norm(const TransportState& a) const;
  /// to += factor from
  void add(TransportState& to, const BandScalars& factor, const TransportState& from) const;
  /// a *= factor
  void scale(TransportState& a, const BandScalars& factor) const;

 private:
  /// Powers of two that bring the largest value of each band near 1 [band].
  BandScalars units(const TransportState& a) const;

  bool is_complex_;

  std::size_t bands_;
  std::size_t stride_;
  int threads_;
  std::vector<double> weights_;  ///< [row], a row being the values of all bands at one place
};

}  // namespace etendue
