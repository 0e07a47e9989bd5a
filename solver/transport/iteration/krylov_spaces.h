// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "solver/transport/iteration/band_hessenberg.h"
#include "solver/transport/iteration/band_vectors.h"
#include "solver/transport/state/transport_state.h"

namespace etendue {

/// Krylov spaces of a cycle of GMRES, one for each band, and their least-squares problems. Bands that are not
/// `active` stay out: their parts of the vectors are zero.
class KrylovSpaces {
 public:
  /// [band][basis vector, then the new norm]
  using Columns = std::vector<std::vector<double>>;

  /// `vectors` must outlive it.
  explicit KrylovSpaces(const BandVectors& vectors) : vectors_(vectors) {}

  /// Begins with a residual and its norms [band].
  void begin(const TransportState& residual, const BandScalars& norms, const std::vector<char>& active);
  /// Gram-Schmidt, twice (Giraud et al. 2005), of what the operator makes of the last vector. Changes
  /// `image`, which, normalised, becomes the next vector.
  Columns orthogonalise(TransportState& image, const std::vector<char>& active);
  /// Solves the least-squares problems with finite columns that orthogonalise() gave.
  void add_columns(const Columns& columns, const std::vector<char>& active);
  void clear() { basis_.clear(); }

  std::size_t size() const { return basis_.size(); }
  const TransportState& vector(std::size_t i) const { return basis_[i]; }
  const TransportState& last() const { return basis_.back(); }
  const BandHessenberg& problem(std::size_t band) const { return problems_[band]; }
  /// Coefficients of a vector in the solution [band].
  BandScalars coefficients(std::size_t i) const;

 private:
  void push_normalised(const TransportState& vector, const BandScalars& norms,
                       const std::vector<char>& active);

  const BandVectors& vectors_;
  std::vector<TransportState> basis_;
  std::vector<BandHessenberg> problems_;  ///< [band]
};

}  // namespace etendue
