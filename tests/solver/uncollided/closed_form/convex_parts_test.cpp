// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/convex_parts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/clipped_polygon.h"

namespace etendue::convex_parts_test {
namespace {

using Triangle = std::array<Vec3, 3>;

/// Triangles of those squares of a board in a tilted plane that are wanted.
template <class Wanted>
std::vector<Triangle> board(int size, const Wanted& wanted) {
  const Vec3 along = Vec3(1, 2, 2).normalized(), across = Vec3(2, 1, -2).normalized();
  const auto at = [&](int x, int y) -> Vec3 { return x * along + y * across; };
  std::vector<Triangle> triangles;
  for (int x = 0; x < size; ++x)
    for (int y = 0; y < size; ++y) {
      if (!wanted(x, y)) continue;
      triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  return triangles;
}

Vec3 normal_of(const std::vector<Triangle>& triangles) {
  const Triangle& t = triangles.front();
  return (t[1] - t[0]).cross(t[2] - t[0]).normalized();
}

double area_of(const std::vector<std::vector<Vec3>>& parts) {
  double area = 0;
  for (const auto& part : parts) area += polygon_area(part);
  return area;
}

/// How many of the parts have the middle of a square of the board.
template <class Parts>
int count_at(const Parts& parts, int x, int y, const Vec3& normal) {
  const Vec3 along = Vec3(1, 2, 2).normalized(), across = Vec3(2, 1, -2).normalized();
  const Vec3 middle = (x + 0.5) * along + (y + 0.5) * across;
  int count = 0;
  for (const auto& part : parts) {
    int left = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Vec3 &a = part[i], &b = part[(i + 1) % part.size()];
      left += normal.dot((b - a).cross(middle - a)) > 0 ? 1 : 0;
    }
    count += left == 0 || left == static_cast<int>(part.size()) ? 1 : 0;
  }
  return count;
}

/// Each square of a piece of a board of eight lies in one part, no other square in any.
template <class Wanted>
void expect_parts(const Wanted& wanted, std::size_t most) {
  const auto triangles = board(8, wanted);
  const Vec3 normal = normal_of(triangles);
  const auto parts = convex_parts(triangles, normal);
  ASSERT_FALSE(parts.empty());
  EXPECT_LE(parts.size(), most);
  EXPECT_NEAR(area_of(parts), static_cast<double>(triangles.size()) / 2, 1e-9);
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y)
      EXPECT_EQ(count_at(parts, x, y, normal), wanted(x, y) ? 1 : 0) << x << ' ' << y;
}

TEST(ConvexParts, AreOneForARectangle) {
  const auto triangles = board(6, [](int, int y) { return y < 4; });
  const auto parts = convex_parts(triangles, normal_of(triangles));
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].size(), 4U);
  EXPECT_NEAR(area_of(parts), 24, 1e-9);
}

TEST(ConvexParts, CoverAnLAWindowAndStairs) {
  expect_parts([](int x, int y) { return x < 3 || y < 2; }, 3);
  expect_parts([](int x, int y) { return x < 2 || x > 4 || y < 3 || y > 6; }, 8);
  expect_parts([](int x, int y) { return x + y < 8; }, 32);
}

TEST(ConvexParts, AreNoneWhereTheyAreMany) {
  const auto chess = board(24, [](int x, int y) { return (x + y) % 2 == 0; });
  EXPECT_TRUE(convex_parts(chess, normal_of(chess)).empty());
}

}  // namespace
}  // namespace etendue::convex_parts_test
