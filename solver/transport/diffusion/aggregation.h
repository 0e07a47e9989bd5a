// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace etendue {

/// Disjoint groups of unknowns that are strongly coupled, a_ij^2 > threshold^2 a_ii a_jj, each about a
/// neighbourhood (Vanek, Mandel and Brezina 1996, algorithm 5.1).
struct Aggregates {
  std::vector<int> of;  ///< [unknown] -1: strongly coupled to nothing, left to the smoother
  int count = 0;
};
Aggregates aggregate(const Eigen::SparseMatrix<double, Eigen::RowMajor>& matrix, double threshold);

/// Coarse functions for level `level` of the hierarchy, 0 the finest, in columns: constants on aggregates,
/// smoothed by a step of Jacobi along the strong couplings.
Eigen::SparseMatrix<double, Eigen::RowMajor> smoothed_prolongation(
    const Eigen::SparseMatrix<double, Eigen::RowMajor>& matrix, int level);

}  // namespace etendue
