// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/sensors/polygon_points.h"

#include <utility>

#include "solver/sensors/sensor.h"

namespace etendue {

Vec3 polygon_normal(const std::vector<Vec3>& polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
  return sum.normalized();
}

// Sub-triangle (i, j) of n^2: corners at i/n and j/n of the two sides, standing up or upside down.
std::vector<PolygonPoint> polygon_points(const std::vector<Vec3>& polygon, int n) {
  std::vector<PolygonPoint> points;
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const Vec3 u = (polygon[k - 1] - polygon[0]) / n, v = (polygon[k] - polygon[0]) / n;
    const double area = u.cross(v).norm() / 2 / 3;
    const auto add = [&](const Vec3& corner, double sign) {
      for (const auto& [a, b] : {std::pair(1. / 6, 1. / 6), {2. / 3, 1. / 6}, {1. / 6, 2. / 3}})
        points.push_back({corner + sign * (a * u + b * v), area});
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        add(polygon[0] + i * u + j * v, 1);
        if (i + j + 1 < n) add(polygon[0] + (i + 1) * u + (j + 1) * v, -1);
      }
  }
  return points;
}

}  // namespace etendue
