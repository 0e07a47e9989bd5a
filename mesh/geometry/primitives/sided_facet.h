// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/position.h"
#include "base/segment.h"
#include "base/vec3.h"

namespace etendue {

/// A flat facet whose two sides are distinguished.
struct SidedFacet {
  /// Points; the facet is on their left, seen from the normal's tip. Edges inside it are in both
  /// directions.
  std::vector<std::array<int, 2>> edges;
  Vec3 normal;  ///< unit
  Vec3 inside;  ///< a point of the facet, off its edges
};

/// Whether the foot of a point on the facet's plane lies in the facet.
inline bool foot_is_inside(const Vec3& x, const std::vector<Vec3>& points, const SidedFacet& facet) {
  int axis = 0;
  facet.normal.cwiseAbs().maxCoeff(&axis);
  const int b = (axis + 1) % 3, c = (axis + 2) % 3;
  const Vec3 foot = x - facet.normal * facet.normal.dot(x - facet.inside);
  bool is_inside = false;  // changes with each edge that a ray in the plane crosses
  for (const auto& [from, to] : facet.edges) {
    const Vec3 &p = points[position(from)], &q = points[position(to)];
    if ((p[b] > foot[b]) == (q[b] > foot[b])) continue;
    if (foot[c] < p[c] + (foot[b] - p[b]) / (q[b] - p[b]) * (q[c] - p[c])) is_inside = !is_inside;
  }
  return is_inside;
}

/// Distance of a point from the facet.
inline double distance_to_facet(const Vec3& x, const std::vector<Vec3>& points, const SidedFacet& facet) {
  if (foot_is_inside(x, points, facet)) return std::abs(facet.normal.dot(x - facet.inside));
  double distance = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : facet.edges)
    distance = std::min(distance, distance_to_segment(x, points[position(from)], points[position(to)]));
  return distance;
}

}  // namespace etendue
