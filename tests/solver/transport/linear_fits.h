// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "base/quadrature/gauss_legendre.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// The best linear fit of a function in each cell, [cell][4]: by a product of Gauss's rules with four points,
/// folded onto the cell, which is exact for polynomials up to degree 4.
inline std::vector<double> linear_fits(const TetrahedralMesh& mesh,
                                       const std::function<double(const Vec3&)>& function) {
  GaussRule rule = gauss_legendre(4);
  for (double& node : rule.nodes) node = (1 + node) / 2;
  for (double& weight : rule.weights) weight /= 2;
  const auto &at = rule.nodes, &of = rule.weights;
  std::vector<double> nodal;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const auto& v = mesh.vertices(CellIndex(c));
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t k = 0; k < 4; ++k) {
          const double x = at[i], y = at[j] * (1 - x), z = at[k] * (1 - x - y);
          const Eigen::Vector4d l(1 - x - y - z, x, y, z);
          Vec3 point = Vec3::Zero();
          for (std::size_t n = 0; n < 4; ++n)
            point += l(static_cast<Eigen::Index>(n)) * mesh.point(VertexIndex(v[n]));
          right += 6 * of[i] * of[j] * of[k] * (1 - x) * (1 - x - y) * function(point) * l;
        }
    const Eigen::Matrix4d mass = (Eigen::Matrix4d::Ones() + Eigen::Matrix4d::Identity()) / 20;
    const Eigen::Vector4d values = mass.ldlt().solve(right);
    nodal.insert(nodal.end(), values.data(), values.data() + 4);
  }
  return nodal;
}

}  // namespace etendue
