// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/sensors/polygon_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace etendue::polygon_points_test {
namespace {

double integral(const std::vector<Vec3>& polygon, int n, const std::function<double(const Vec3&)>& function) {
  double sum = 0;
  for (const PolygonPoint& point : polygon_points(polygon, n)) sum += point.area * function(point.position);
  return sum;
}

/// An L: a square of side 2 without its upper right quarter; and a comb of two teeth.
const std::vector<Vec3> ell = {{0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}, {1, 2, 1}, {0, 2, 1}};
const std::vector<Vec3> comb = {{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {2, 2, 0},
                                {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};

std::vector<Vec3> turned(std::vector<Vec3> polygon, std::size_t by) {
  std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(by), polygon.end());
  return polygon;
}

// Quadratics are integrated exactly, whichever corner is the first and whichever way round they stand.
TEST(PolygonPoints, IntegrateQuadraticsOverAnyPolygon) {
  const auto one = [](const Vec3&) { return 1.0; };
  const auto product = [](const Vec3& p) { return p.x() * p.y(); };
  for (std::size_t first = 0; first < 8; ++first)
    for (const bool back : {false, true}) {
      std::vector<Vec3> l = turned(ell, first % ell.size()), c = turned(comb, first);
      if (back) std::ranges::reverse(l), std::ranges::reverse(c);
      for (const int n : {1, 3}) {
        EXPECT_NEAR(integral(l, n, one), 3, 1e-13);
        // Of the square 4, less 3/2 * 3/2 * 1 of the quarter.
        EXPECT_NEAR(integral(l, n, product), 4 - 2.25, 1e-13);
        EXPECT_NEAR(integral(c, n, one), 5, 1e-13);
        // Of the rectangle 9/2 * 2, less 3/2 * 3/2 of the gap.
        EXPECT_NEAR(integral(c, n, product), 9 - 2.25, 1e-13);
      }
    }
}

TEST(PolygonPoints, LieInThePolygon) {
  for (const PolygonPoint& point : polygon_points(ell, 4))
    EXPECT_FALSE(point.position.x() > 1 && point.position.y() > 1);
  for (const PolygonPoint& point : polygon_points(comb, 4))
    EXPECT_FALSE(point.position.x() > 1 && point.position.x() < 2 && point.position.y() > 1);
}

}  // namespace
}  // namespace etendue::polygon_points_test
