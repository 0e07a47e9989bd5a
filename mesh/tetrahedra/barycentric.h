// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>

#include "mesh/tetrahedra/corners.h"

namespace etendue {

/// Barycentric coordinates of a point in a cell, in the order of its vertices; they sum to 1.
inline std::array<double, 4> barycentric(const TetrahedralMesh& mesh, CellIndex cell, const Vec3& point) {
  const std::array<Vec3, 4> corners = corners_of(mesh, cell);
  const Vec3& origin = corners[0];
  const Vec3 a = corners[1] - origin, b = corners[2] - origin, c = corners[3] - origin, p = point - origin;
  const Vec3 bc = b.cross(c);
  const double det = a.dot(bc);
  const double x = p.dot(bc) / det, y = p.dot(c.cross(a)) / det, z = p.dot(a.cross(b)) / det;
  return {1 - x - y - z, x, y, z};
}

}  // namespace etendue
