// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

#include "solver/transport/diffusion/chebyshev.h"

namespace etendue {

/// Up to so many unknowns are solved directly.
inline constexpr int largest_direct_system = 2000;

/// Solves sparse symmetric positive definite systems such as those of continuous linear elements: directly
/// where they are small, else by cycles of smoothed aggregation (Vanek, Mandel and Brezina 1996), whose work
/// and memory grow as the unknowns do. Aggregates do not reach across jumps of the coefficient.
class VertexMultigrid {
 public:
  /// `lower` is the lower triangle. Throws std::domain_error where the matrix is not positive definite.
  explicit VertexMultigrid(const Eigen::SparseMatrix<double>& lower, int direct = largest_direct_system);

  /// About matrix^-1 `right`: a fixed linear map, symmetric and positive definite, so that it can be part of
  /// a preconditioner.
  Eigen::VectorXd approximate(const Eigen::VectorXd& right) const;
  /// The direct one included.
  int level_count() const { return static_cast<int>(levels_.size()) + 1; }
  /// Entries of the matrices of all levels, over those of the finest.
  double operator_complexity() const { return complexity_; }

 private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  struct Level {
    Matrix matrix;
    Matrix prolongation;  ///< from the next coarser level
    Matrix restriction;   ///< its transpose
  };

  void measure_cycle();
  Eigen::VectorXd cycle(std::size_t level, const Eigen::VectorXd& right) const;

  std::vector<Level> levels_;  ///< the finest first
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> coarsest_;
  SpectrumBounds spectrum_;  ///< of a cycle times the matrix
  double complexity_ = 1;
};

}  // namespace etendue
