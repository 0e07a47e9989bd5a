// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/quadrature/simplex_cubature.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace etendue::simplex_cubature_test {
namespace {

const std::array<Vec3, 4> corner = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};

std::vector<double> over(std::size_t corners, const std::function<double(const Vec3&)>& f,
                         std::size_t points) {
  return integrate_over_simplex(std::span(corner).first(corners), 1,
                                [&](const Vec3& x, std::span<double> values) { values[0] += f(x); },
                                {1e-7, points});
}

TEST(SimplexCubature, IsExactForParabolas) {
  EXPECT_NEAR(over(
                  3, [](const Vec3& x) { return 1 + x.x() * x.y(); }, 1)[0],
              0.5 + 1. / 24, 1e-15);
  EXPECT_NEAR(over(
                  4, [](const Vec3& x) { return 1 + x.x() * x.y(); }, 1)[0],
              1. / 6 + 1. / 120, 1e-15);
}

// Within the distance 1/2 of a corner lies pi/16 of the triangle, and pi/48 of the tetrahedron. What the edge
// cuts off of a part between its points is not seen.
TEST(SimplexCubature, FindsWhereFunctionsJump) {
  const auto near = [](const Vec3& x) { return x.norm() < 0.5 ? 1. : 0.; };
  EXPECT_NEAR(over(3, near, 3000)[0] / (std::numbers::pi / 16), 1, 1e-2);
  EXPECT_NEAR(over(4, near, 20000)[0] / (std::numbers::pi / 48), 1, 1e-2);
}

// 1/r^2 about a corner of the tetrahedron is integrable.
TEST(SimplexCubature, RefinesWhereFunctionsGrow) {
  const auto inverse = [](const Vec3& x) { return 1 / x.squaredNorm(); };
  const double coarse = over(4, inverse, 2000)[0], fine = over(4, inverse, 20000)[0];
  EXPECT_NEAR(coarse / fine, 1, 5e-3);
}

}  // namespace
}  // namespace etendue::simplex_cubature_test
