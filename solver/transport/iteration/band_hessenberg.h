// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace etendue {

/// Least-squares problem of GMRES for one band: the Hessenberg matrix H of I - T on the Krylov basis, and the
/// y that minimizes |start e_0 - H y| (Saad and Schultz 1986).
class BandHessenberg {
 public:
  /// `start` is the norm of the residual that the basis begins with.
  explicit BandHessenberg(double start) : start_(start), residual_(Eigen::VectorXd::Constant(1, start)) {}

  /// Adds the products with all basis vectors, the new one last, and solves.
  void add_column(const std::vector<double>& entries);

  /// Norm of the residual, of any size.
  double residual() const { return residual_.stableNorm(); }
  /// Coefficient of a basis vector in the residual.
  double residual_coefficient(std::size_t row) const { return entry(residual_, row); }
  /// Coefficient of a basis vector in the solution.
  double coefficient(std::size_t column) const { return entry(solution_, column); }
  /// Estimate of the smallest singular value of I - T, between rounding and 1.
  double smallest_singular_value() const { return smallest_; }

 private:
  static double entry(const Eigen::VectorXd& vector, std::size_t at) {
    return static_cast<Eigen::Index>(at) < vector.size() ? vector(static_cast<Eigen::Index>(at)) : 0;
  }

  double start_;
  double smallest_ = 1;
  Eigen::VectorXd residual_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd solution_;
};

}  // namespace etendue
