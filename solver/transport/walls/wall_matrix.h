// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "solver/angular/sets/direction_set.h"
#include "solver/materials/surfaces/reflectance.h"

namespace etendue {

/// Energy balance of a matrix before it was scaled: the smallest and largest ratio of a row sum to the
/// albedo.
struct RowSums {
  double smallest = 1, largest = 1;
};

/// A reflectance on the ordinates of a flat wall. A pair of opposite ordinates has one that arrives and one
/// that leaves; with c = w |w.n| of a pair
///
///     u_p = sum over q of M_pq u_q,    M_pq = s_p F_pq s_q c_q,    F_pq = f_r(q arrives -> p leaves).
///
/// F is symmetric, since f_r is reciprocal, and stays so; the factors s are such that of light along each
/// arriving ordinate exactly the albedo is reflected, sum over p of c_p M_pq = a_q c_q (symmetric scaling,
/// Sinkhorn 1964). Where a lobe is so narrow that it falls between the ordinates the nearest one takes it.
class WallMatrix {
 public:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// Of a wall whose unit normal points out of the domain.
  WallMatrix(const DirectionSet& directions, const Vec3& normal, const Reflectance& reflectance);

  const Matrix& entries() const { return entries_; }     ///< [pair that leaves][pair that arrives]
  double mean_albedo() const { return mean_albedo_; }    ///< of light that is the same from all directions
  const RowSums& row_sums() const { return row_sums_; }  ///< before scaling

  /// Doubles that one takes.
  static double size(const DirectionSet& directions) { return directions.count() * directions.count() / 4.0; }

 private:
  void scale(const Eigen::VectorXd& across, const Eigen::VectorXd& albedo);

  Matrix entries_;
  double mean_albedo_ = 0;
  RowSums row_sums_;
};

}  // namespace etendue
