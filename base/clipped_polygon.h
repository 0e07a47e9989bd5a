// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec3.h"

namespace etendue {

inline double triangle_area(const std::array<Vec3, 3>& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() / 2;
}

/// Of a flat convex polygon.
inline double polygon_area(const std::vector<Vec3>& corners) {
  double area = 0;
  for (std::size_t i = 2; i < corners.size(); ++i)
    area += triangle_area({corners[0], corners[i - 1], corners[i]});
  return area;
}

/// The part of a convex polygon where n.(x - p) >= 0; of a cone, given by the vectors along its edges, with p
/// = 0. Corners that miss the plane by `tolerance` lie on it.
inline std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, const Vec3& normal,
                                 const Vec3& p = Vec3::Zero(), double tolerance = 0) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& here = polygon[i];
    const Vec3& next = polygon[(i + 1) % polygon.size()];
    const double at_here = normal.dot(here - p), at_next = normal.dot(next - p);
    if (at_here >= -tolerance) kept.push_back(here);
    if ((at_here > tolerance && at_next < -tolerance) || (at_here < -tolerance && at_next > tolerance))
      kept.emplace_back((at_here * next - at_next * here) / (at_here - at_next));
  }
  return kept;
}

}  // namespace etendue
