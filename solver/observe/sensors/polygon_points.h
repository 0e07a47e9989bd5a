// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vec3.h"

namespace etendue {

/// A point of a rule on a polygon and the area that it represents.
struct PolygonPoint {
  Vec3 position;
  double area;
};

/// Those of a flat polygon whose sides meet at its corners alone: it is cut into triangles, a convex one
/// about its first corner, others by their ears (Meisters 1975), and each of them in n^2 equal ones with the
/// three points of degree 2 in each.
std::vector<PolygonPoint> polygon_points(const std::vector<Vec3>& polygon, int n);

}  // namespace etendue
