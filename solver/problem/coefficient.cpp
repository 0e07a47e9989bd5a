// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/coefficient.h"

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "solver/problem/cell_rule.h"

namespace etendue {

double Coefficient::at(const Vec3& point) const {
  return formula_ ? (*formula_)(std::span<const double>(point.data(), 3)) : value_;
}

std::string Coefficient::text() const { return formula_ ? formula_->text() : fmt::format("{:.17g}", value_); }

CellSample Coefficient::sample(const std::array<Vec3, 4>& vertices) const {
  if (is_constant()) return {value_, value_, point_at({0.25, 0.25, 0.25, 0.25}, vertices)};
  CellSample sample{0, HUGE_VAL, Vec3::Zero()};
  for (const CellRulePoint& node : cell_rule()) {
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
