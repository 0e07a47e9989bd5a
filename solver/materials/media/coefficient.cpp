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

/// Values at the vertices less the mean: with the moments m_i, means of the coefficient times barycentric
/// coordinate i: M^-1 m with the mass matrix M_ij = (1 + delta_ij)/20 is 20 m_i - 4 sum m_j, and the sum is
/// the mean.
std::array<double, 4> closest_slope(const std::array<double, 4>& moments, double mean) {
  std::array<double, 4> slope;
  for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = 20 * moments[i] - 5 * mean;
  const double lowest = std::ranges::min(slope);
  if (mean + lowest >= 0) return slope;
  for (double& value : slope) value *= mean / -lowest;
  return slope;
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
  std::array<double, 4> moments = {};
  for (const CellRulePoint& node : rule(vertices)) {
    const Vec3 point = point_at(node.barycentric, vertices);
    const double value = at(point);
    if (!std::isfinite(value)) return {value, value, point};
    sample.mean += node.weight * value;
    for (std::size_t i = 0; i < moments.size(); ++i) moments[i] += node.weight * value * node.barycentric[i];
    if (value < sample.smallest) {
      sample.smallest = value;
      sample.where = point;
    }
  }
  sample.slope = closest_slope(moments, sample.mean);
  return sample;
}

}  // namespace etendue
