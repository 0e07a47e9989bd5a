// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// A point by its barycentric coordinates, and its part of the volume.
struct CellRulePoint {
  std::array<double, 4> barycentric;
  double weight;
};

/// Fourteen points inside a tetrahedron with positive weights that sum to 1, exact to degree 5.
const std::array<CellRulePoint, 14>& cell_rule();

/// The same points in each of the 8^level tetrahedra that a tetrahedron is cut into by halving its edges so
/// often, as barycentric coordinates of the whole; `level` is at most `largest_rule_level`.
inline constexpr int largest_rule_level = 3;
const std::vector<CellRulePoint>& composite_cell_rule(int level);

Vec3 point_at(const std::array<double, 4>& barycentric, const std::array<Vec3, 4>& vertices);

}  // namespace etendue
