// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/iteration/krylov_spaces.h"

namespace etendue {

void KrylovSpaces::begin(const TransportState& residual, const BandScalars& norms,
                         const std::vector<char>& active) {
  basis_.clear();
  problems_.clear();
  for (std::size_t band = 0; band < norms.size(); ++band)
    problems_.emplace_back(active[band] ? norms[band] : 0);
  push_normalised(residual, norms, active);
}

void KrylovSpaces::push_normalised(const TransportState& vector, const BandScalars& norms,
                                   const std::vector<char>& active) {
  BandScalars factor;
  for (std::size_t band = 0; band < norms.size(); ++band)
    factor.push_back(norms[band] > 0 && active[band] ? 1 / norms[band] : 0);
  basis_.push_back(vector);
  vectors_.scale(basis_.back(), factor);
}

KrylovSpaces::Columns KrylovSpaces::orthogonalise(TransportState& image, const std::vector<char>& active) {
  Columns columns(active.size(), std::vector<double>(basis_.size() + 1, 0));
  for (int pass = 0; pass < 2; ++pass)
    for (std::size_t i = 0; i < basis_.size(); ++i) {
      BandScalars projection = vectors_.dot(basis_[i], image);
      for (std::size_t band = 0; band < active.size(); ++band) {
        columns[band][i] += projection[band];
        projection[band] = -projection[band];
      }
      vectors_.add(image, projection, basis_[i]);
    }
  const BandScalars norms = vectors_.norm(image);
  for (std::size_t band = 0; band < active.size(); ++band) columns[band].back() = norms[band];
  push_normalised(image, norms, active);
  return columns;
}

void KrylovSpaces::add_columns(const Columns& columns, const std::vector<char>& active) {
  for (std::size_t band = 0; band < active.size(); ++band)
    if (active[band]) problems_[band].add_column(columns[band]);
}

BandScalars KrylovSpaces::coefficients(std::size_t i) const {
  BandScalars result;
  for (const BandHessenberg& problem : problems_) result.push_back(problem.coefficient(i));
  return result;
}

}  // namespace etendue
