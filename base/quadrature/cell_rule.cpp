// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/quadrature/cell_rule.h"

#include <utility>

namespace etendue {
namespace {

/// Walkington's 14-point rule of degree 5 (N. J. Walkington, Quadrature on simplices of arbitrary dimension,
/// Carnegie Mellon University, 2000): four points near the vertices, four near the faces' centres, six near
/// the edges' middles. The numbers solve the moment equations to 20 digits.
std::array<CellRulePoint, 14> walkington_rule() {
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

using Corners = std::array<Eigen::Vector4d, 4>;  ///< of a part, by barycentric coordinates of the whole

/// The corners are cut off, and the octahedron between them into four around a diagonal.
std::array<Corners, 8> halved(const Corners& c) {
  const auto middle = [&c](std::size_t i, std::size_t j) -> Eigen::Vector4d { return 0.5 * (c[i] + c[j]); };
  const Eigen::Vector4d m01 = middle(0, 1), m02 = middle(0, 2), m03 = middle(0, 3), m12 = middle(1, 2),
                        m13 = middle(1, 3), m23 = middle(2, 3);
  return {{{c[0], m01, m02, m03},
           {c[1], m01, m12, m13},
           {c[2], m02, m12, m23},
           {c[3], m03, m13, m23},
           {m01, m23, m02, m12},
           {m01, m23, m12, m13},
           {m01, m23, m13, m03},
           {m01, m23, m03, m02}}};
}

void add_points(const Corners& corners, int level, double volume, std::vector<CellRulePoint>& rule) {
  if (level > 0) {
    for (const Corners& part : halved(corners)) add_points(part, level - 1, volume / 8, rule);
    return;
  }
  for (const CellRulePoint& node : cell_rule()) {
    Eigen::Vector4d point = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < 4; ++i) point += node.barycentric[i] * corners[i];
    rule.push_back({{point[0], point[1], point[2], point[3]}, volume * node.weight});
  }
}

std::vector<CellRulePoint> make_composite_rule(int level) {
  std::vector<CellRulePoint> rule;
  add_points({Eigen::Vector4d::Unit(0), Eigen::Vector4d::Unit(1), Eigen::Vector4d::Unit(2),
              Eigen::Vector4d::Unit(3)},
             level, 1, rule);
  return rule;
}

}  // namespace

const std::vector<CellRulePoint>& composite_cell_rule(int level) {
  static const std::array<std::vector<CellRulePoint>, largest_rule_level + 1> rules = {
      make_composite_rule(0), make_composite_rule(1), make_composite_rule(2), make_composite_rule(3)};
  return rules[static_cast<std::size_t>(level)];
}

const std::array<CellRulePoint, 14>& cell_rule() {
  static const std::array<CellRulePoint, 14> rule = walkington_rule();
  return rule;
}

Vec3 point_at(const std::array<double, 4>& barycentric, const std::array<Vec3, 4>& vertices) {
  Vec3 point = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) point += barycentric[i] * vertices[i];
  return point;
}

}  // namespace etendue
