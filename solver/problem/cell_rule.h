// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>

#include "mesh/base/vec3.h"

namespace etendue {

/// A point by its barycentric coordinates, and its part of the volume.
struct CellRulePoint {
  std::array<double, 4> barycentric;
  double weight;
};

/// Fourteen points inside a tetrahedron with positive weights that sum to 1, exact to degree 5.
const std::array<CellRulePoint, 14>& cell_rule();

Vec3 point_at(const std::array<double, 4>& barycentric, const std::array<Vec3, 4>& vertices);

}  // namespace etendue
