// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/harmonics/continuous_harmonics.h"

#include <Eigen/QR>
#include <vector>

#include "solver/angular/harmonics/spherical_harmonics.h"

namespace etendue {

ContinuousHarmonics::ContinuousHarmonics(const DirectionSet& set, int degree)
    : space_(set.space()), degree_(degree), discrete_(set, degree) {
  Eigen::MatrixXd raw(set.count(), harmonic_count(space_, degree)), wanted(set.count(), discrete_.count());
  std::vector<double> row(static_cast<std::size_t>(raw.cols()));
  for (int m = 0; m < set.count(); ++m) {
    harmonics(space_, set.direction(OrdinateIndex(m)), degree, row);
    raw.row(m) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), raw.cols());
    for (int k = 0; k < discrete_.count(); ++k) wanted(m, k) = discrete_.value(k, OrdinateIndex(m));
  }
  combination_ = Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(raw).solve(wanted).transpose();
}

void ContinuousHarmonics::at(const Vec3& direction, std::span<double> values) const {
  std::vector<double> raw(static_cast<std::size_t>(combination_.cols()));
  harmonics(space_, direction, degree_, raw);
  Eigen::Map<Eigen::VectorXd>(values.data(), combination_.rows()).noalias() =
      combination_ * Eigen::Map<const Eigen::VectorXd>(raw.data(), combination_.cols());
}

}  // namespace etendue
