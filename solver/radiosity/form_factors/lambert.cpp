// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/form_factors/lambert.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace etendue {

std::vector<Vec3> clipped_polygon(Corners polygon, const Vec3& normal, double offset) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& here = polygon[i];
    const Vec3& next = polygon[(i + 1) % polygon.size()];
    const double at_here = normal.dot(here) - offset, at_next = normal.dot(next) - offset;
    if (at_here >= 0) kept.push_back(here);
    if ((at_here > 0 && at_next < 0) || (at_here < 0 && at_next > 0))
      kept.emplace_back((at_here * next - at_next * here) / (at_here - at_next));
  }
  return kept;
}

Vec3 lambert_vector(const Vec3& point, Corners polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point;
    const Vec3 across = b.cross(a);
    const double length = across.norm();
    // An edge through the point spans no plane.
    if (length > 0) sum += std::atan2(length, a.dot(b)) / length * across;
  }
  return sum / 2;
}

double solid_angle(const Vec3& point, const TriangleCorners& triangle) {
  const Vec3 a = triangle[0] - point, b = triangle[1] - point, c = triangle[2] - point;
  const double x = a.norm(), y = b.norm(), z = c.norm();
  const double below = x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y;
  return -2 * std::atan2(a.dot(b.cross(c)), below);
}

double point_factor(const Vec3& point, const Vec3& normal, Corners polygon) {
  const std::vector<Vec3> seen = clipped_polygon(polygon, normal, normal.dot(point));
  if (seen.size() < 3) return 0;
  return std::max(0.0, normal.dot(lambert_vector(point, seen)) / std::numbers::pi);
}

}  // namespace etendue
