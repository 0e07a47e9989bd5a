// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/cell_rule.h"

#include <utility>

namespace etendue {
namespace {

/// Walkington's 14-point rule of degree 5 (N. J. Walkington, Quadrature on simplices of arbitrary dimension,
/// Carnegie Mellon University, 2000): four points near the vertices, four near the faces' centres, six near
/// the edges' middles. The numbers solve the moment equations to 20 digits.
std::array<CellRulePoint, 14> make_rule() {
  constexpr double near_face = 0.31088591926330060980, near_vertex = 0.092735250310891226402;
  constexpr double near_edge = 0.045503704125649649492;
  constexpr double face_weight = 0.11268792571801585080, vertex_weight = 0.073493043116361949544;
  constexpr double edge_weight = 0.042546020777081466438;
  std::array<CellRulePoint, 14> rule;
  std::size_t n = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (const auto& [other, weight] :
         {std::pair(near_face, face_weight), std::pair(near_vertex, vertex_weight)}) {
      rule[n] = {{other, other, other, other}, weight};
      rule[n++].barycentric[i] = 1 - 3 * other;
    }
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      rule[n] = {{near_edge, near_edge, near_edge, near_edge}, edge_weight};
      rule[n].barycentric[i] = rule[n].barycentric[j] = 0.5 - near_edge;
      ++n;
    }
  return rule;
}

}  // namespace

const std::array<CellRulePoint, 14>& cell_rule() {
  static const std::array<CellRulePoint, 14> rule = make_rule();
  return rule;
}

Vec3 point_at(const std::array<double, 4>& barycentric, const std::array<Vec3, 4>& vertices) {
  Vec3 point = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) point += barycentric[i] * vertices[i];
  return point;
}

}  // namespace etendue
