// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/form_factors/exchange_area.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/quadrature/adaptive_rule.h"

namespace etendue::exchange_area_test {
namespace {

FlatPatch rectangle(const Vec3& corner, const Vec3& u, const Vec3& v) {
  const std::vector<Vec3> corners = {corner, corner + u, corner + u + v, corner + v};
  return FlatPatch::polygon(corners);
}

const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();

TEST(AdaptiveRule, IsExactForPolynomialsAndFindsLogarithms) {
  for (int degree = 0; degree <= 12; ++degree)
    EXPECT_NEAR(adaptive_integral([&](double s) { return std::pow(s, degree); }, 0, 1, 1), 1.0 / (degree + 1),
                1e-15);
  EXPECT_NEAR(adaptive_integral([](double s) { return std::log(s); }, 0, 1, 1e-10), -1, 1e-10);
}

TEST(FlatPatch, TrianglesOfAGridHaveTheOutlineOfTheirUnion) {
  std::vector<TriangleCorners> triangles;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      if (i == 1 && j == 1) continue;
      const Vec3 a = i * x + j * y, b = a + x, c = a + x + y, d = a + y;
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  const FlatPatch ring(triangles);
  EXPECT_EQ(ring.contour().size(), 8u);
  EXPECT_DOUBLE_EQ(ring.area(), 8);
  EXPECT_NEAR((ring.normal() - z).norm(), 0, 1e-15);
}

// What a surface sends to another is the sum of what its parts send, however they touch.
TEST(ExchangeArea, IsAdditive) {
  const FlatPatch floor = rectangle(Vec3::Zero(), 2 * x, 3 * y);
  const FlatPatch wall = rectangle(Vec3::Zero(), 3 * y, 1.5 * z);
  double sum = 0;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        sum += exchange_area(rectangle(i * x + j * y, x, y), rectangle(k * y, y, 1.5 * z));
  EXPECT_NEAR(sum, exchange_area(floor, wall), 1e-7);
}

TEST(ExchangeArea, IsTheSameBothWays) {
  const FlatPatch a = rectangle(Vec3::Zero(), x, y), b({{Vec3(0.3, -1, 2), Vec3(0, 2, 1), Vec3(3, 0.5, 1)}});
  EXPECT_GT(exchange_area(a, b), 0.01);
  EXPECT_NEAR(exchange_area(a, b), exchange_area(b, a), 1e-9);
}

TEST(ExchangeArea, FlatPatchesDoNotSeeThemselvesOrTheirPlane) {
  const FlatPatch a = rectangle(Vec3::Zero(), x, y), beside = rectangle(x, x, y);
  EXPECT_EQ(exchange_area(a, a), 0);
  EXPECT_EQ(exchange_area(a, beside), 0);
}

// A wall through the middle of the plane of another: only the half before it is seen.
TEST(ExchangeArea, ThePartBehindIsCutAway) {
  const FlatPatch floor = rectangle(Vec3::Zero(), x, y);
  const FlatPatch through = rectangle(-z, y, 2 * z), above = rectangle(Vec3::Zero(), y, z);
  EXPECT_NEAR(exchange_area(floor, through), exchange_area(floor, above), 1e-9);
}

TEST(ExchangeArea, FarPatchesBySumsAgreeWithContours) {
  const FlatPatch a({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.2, 0.9, 0)}});
  for (const double height : {7.0, 10.0, 30.0}) {
    const FlatPatch b({{Vec3(1, 0, height), Vec3(1, 1, height + 0.3), Vec3(2, 0, height)}});
    const double exact = exchange_area_by_contours(a, b);
    EXPECT_NEAR(exchange_area(a, b) / exact, 1, 1e-6) << height;
  }
}

}  // namespace
}  // namespace etendue::exchange_area_test
