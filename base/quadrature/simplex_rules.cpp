// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/quadrature/simplex_rules.h"

#include <cmath>

namespace etendue {
namespace {

template <std::size_t corners>
std::array<double, corners> middle(const std::array<double, corners>& a,
                                   const std::array<double, corners>& b) {
  std::array<double, corners> m{};
  for (std::size_t i = 0; i < corners; ++i) m[i] = (a[i] + b[i]) / 2;
  return m;
}

}  // namespace

SubTetrahedron whole_cell() {
  SubTetrahedron whole{};
  for (std::size_t i = 0; i < 4; ++i) whole[i][i] = 1;
  return whole;
}

std::array<SubTetrahedron, 8> equal_parts(const SubTetrahedron& w) {
  const auto m01 = middle(w[0], w[1]), m02 = middle(w[0], w[2]), m03 = middle(w[0], w[3]),
             m12 = middle(w[1], w[2]), m13 = middle(w[1], w[3]), m23 = middle(w[2], w[3]);
  return {SubTetrahedron{w[0], m01, m02, m03}, SubTetrahedron{m01, w[1], m12, m13},
          SubTetrahedron{m02, m12, w[2], m23}, SubTetrahedron{m03, m13, m23, w[3]},
          SubTetrahedron{m02, m13, m01, m03},  SubTetrahedron{m02, m13, m03, m23},
          SubTetrahedron{m02, m13, m23, m12},  SubTetrahedron{m02, m13, m12, m01}};
}

std::array<SubTriangle, 4> equal_parts(const SubTriangle& w) {
  const auto m01 = middle(w[0], w[1]), m12 = middle(w[1], w[2]), m20 = middle(w[2], w[0]);
  return {SubTriangle{w[0], m01, m20}, SubTriangle{m01, w[1], m12}, SubTriangle{m20, m12, w[2]},
          SubTriangle{m01, m12, m20}};
}

const std::array<CellPointWeight, 4>& four_point_rule() {
  static const std::array<CellPointWeight, 4> rule = [] {
    std::array<CellPointWeight, 4> points{};
    const double other = (5 - std::sqrt(5.0)) / 20;
    for (std::size_t i = 0; i < 4; ++i) {
      points[i] = {{other, other, other, other}, 0.25};
      points[i].barycentric[i] = 1 - 3 * other;
    }
    return points;
  }();
  return rule;
}

const std::array<FacePointWeight, 3>& three_point_rule() {
  static const std::array<FacePointWeight, 3> rule = {{{{2. / 3, 1. / 6, 1. / 6}, 1. / 3},
                                                       {{1. / 6, 2. / 3, 1. / 6}, 1. / 3},
                                                       {{1. / 6, 1. / 6, 2. / 3}, 1. / 3}}};
  return rule;
}

const std::array<FacePointWeight, 7>& seven_point_rule() {
  static const std::array<FacePointWeight, 7> rule = [] {
    const double root = std::sqrt(15.0);
    const double near = (6 - root) / 21, far = (6 + root) / 21;
    const double of_near = (155 - root) / 1200, of_far = (155 + root) / 1200;
    std::array<FacePointWeight, 7> points{};
    points[0] = {{1. / 3, 1. / 3, 1. / 3}, 9. / 40};
    for (std::size_t i = 0; i < 3; ++i) {
      points[1 + i] = {{near, near, near}, of_near};
      points[1 + i].barycentric[i] = 1 - 2 * near;
      points[4 + i] = {{far, far, far}, of_far};
      points[4 + i].barycentric[i] = 1 - 2 * far;
    }
    return points;
  }();
  return rule;
}

}  // namespace etendue
