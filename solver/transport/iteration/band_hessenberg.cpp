// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/iteration/band_hessenberg.h"

#include <Eigen/SVD>
#include <algorithm>
#include <limits>

namespace etendue {

void BandHessenberg::add_column(const std::vector<double>& entries) {
  const auto columns = static_cast<Eigen::Index>(entries.size()) - 1;
  matrix_.conservativeResizeLike(Eigen::MatrixXd::Zero(columns + 1, columns));
  for (Eigen::Index i = 0; i <= columns; ++i) matrix_(i, columns - 1) = entries[static_cast<std::size_t>(i)];
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix_, Eigen::ComputeThinU | Eigen::ComputeThinV);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(columns + 1);
  right(0) = start_;
  // Of a singular matrix the error is unknown, not infinite.
  smallest_ = std::clamp(svd.singularValues().minCoeff(), std::numeric_limits<double>::epsilon(), 1.0);
  solution_ = svd.solve(right);
  residual_ = right - matrix_ * solution_;
}

}  // namespace etendue
