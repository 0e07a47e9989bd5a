// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/media/coefficient.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace etendue {
namespace {

/// Edge of the regular tetrahedron of the same volume [length].
double edge_length(const std::array<Vec3, 4>& v) {
  return std::cbrt(std::numbers::sqrt2 * std::abs((v[1] - v[0]).cross(v[2] - v[0]).dot(v[3] - v[0])));
}

/// Returns whether a tetrahedron holds a jump of a function, as far as the points of the rule see.
bool jumps_in(const PlaceFunction& function, const std::array<Vec3, 4>& vertices) {
  if (!function.has_jumps()) return false;
  const double first = function.at(point_at(cell_rule()[0].barycentric, vertices));
  return std::ranges::any_of(cell_rule(), [&](const CellRulePoint& node) {
    return function.at(point_at(node.barycentric, vertices)) != first;
  });
}

/// Around the middle and the corners of a tetrahedron [length].
double smooth_length(const PlaceFunction& function, const std::array<Vec3, 4>& vertices) {
  double length = function.smooth_length(point_at({0.25, 0.25, 0.25, 0.25}, vertices));
  for (const Vec3& vertex : vertices) length = std::min(length, function.smooth_length(vertex));
  return length;
}

}  // namespace

double Coefficient::at(const Vec3& point) const {
  return formula_ ? (*formula_)(std::span<const double>(point.data(), 3)) : value_;
}

std::string Coefficient::text() const { return formula_ ? formula_->text() : fmt::format("{:.17g}", value_); }

std::span<const CellRulePoint> Coefficient::rule(const std::array<Vec3, 4>& vertices) const {
  if (is_constant() || formula_->formula().functions.empty()) return cell_rule();
  double smooth = HUGE_VAL;
  bool jumps = false;
  for (const auto& [name, function] : formula_->formula().functions) {
    smooth = std::min(smooth, smooth_length(*function, vertices));
    jumps = jumps || jumps_in(*function, vertices);
  }
  double halvings = std::max(std::round(std::log2(edge_length(vertices) / smooth)), 0.0);
  if (jumps) ++halvings;
  return composite_cell_rule(static_cast<int>(std::min(halvings, double{largest_rule_level})));
}

CellSample Coefficient::sample(const std::array<Vec3, 4>& vertices) const {
  if (is_constant()) return {value_, value_, point_at({0.25, 0.25, 0.25, 0.25}, vertices)};
  CellSample sample{0, HUGE_VAL, Vec3::Zero()};
  for (const CellRulePoint& node : rule(vertices)) {
    const Vec3 point = point_at(node.barycentric, vertices);
    const double value = at(point);
    if (!std::isfinite(value)) return {value, value, point};
    sample.mean += node.weight * value;
    if (value < sample.smallest) {
      sample.smallest = value;
      sample.where = point;
    }
  }
  return sample;
}

}  // namespace etendue
