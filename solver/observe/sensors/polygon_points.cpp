// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/sensors/polygon_points.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "solver/observe/sensors/sensor.h"

namespace etendue {

Vec3 polygon_normal(const std::vector<Vec3>& polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
  return sum.normalized();
}

namespace {

using Triangle = std::array<Vec3, 3>;

bool triangle_holds(const Triangle& triangle, const Vec3& normal, const Vec3& point) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a = triangle[i], &b = triangle[(i + 1) % 3];
    if (point == a || normal.dot((b - a).cross(point - a)) < 0) return false;
  }
  return true;
}

/// The corner that can be cut off: the polygon turns there to the left, and no other corner lies in the
/// triangle with the two beside it. There is one always, but for rounding.
std::size_t ear_of(const std::vector<Vec3>& polygon, const Vec3& normal) {
  for (std::size_t i = 1; i <= polygon.size(); ++i) {
    const Triangle cut = {polygon[i - 1], polygon[i % polygon.size()], polygon[(i + 1) % polygon.size()]};
    const bool left = normal.dot((cut[1] - cut[0]).cross(cut[2] - cut[1])) >= 0;
    if (left && std::ranges::none_of(polygon, [&](const Vec3& p) { return triangle_holds(cut, normal, p); }))
      return i % polygon.size();
  }
  return 1;
}

std::vector<Triangle> triangles_of(std::vector<Vec3> left) {
  const Vec3 normal = polygon_normal(left);
  std::vector<Triangle> triangles;
  while (left.size() > 2) {
    const std::size_t count = left.size(), ear = ear_of(left, normal);
    triangles.push_back({left[(ear + count - 1) % count], left[ear], left[(ear + 1) % count]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return triangles;
}

}  // namespace

// Sub-triangle (i, j) of n^2: corners at i/n and j/n of the two sides, standing up or upside down.
std::vector<PolygonPoint> polygon_points(const std::vector<Vec3>& polygon, int n) {
  std::vector<PolygonPoint> points;
  for (const auto& [origin, second, third] : triangles_of(polygon)) {
    const Vec3 from = origin, u = (second - origin) / n, v = (third - origin) / n;
    const double area = u.cross(v).norm() / 2 / 3;
    const auto add = [&](const Vec3& corner, double sign) {
      for (const auto& [a, b] : {std::pair(1. / 6, 1. / 6), {2. / 3, 1. / 6}, {1. / 6, 2. / 3}})
        points.push_back({corner + sign * (a * u + b * v), area});
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        add(from + i * u + j * v, 1);
        if (i + j + 1 < n) add(from + (i + 1) * u + (j + 1) * v, -1);
      }
  }
  return points;
}

}  // namespace etendue
