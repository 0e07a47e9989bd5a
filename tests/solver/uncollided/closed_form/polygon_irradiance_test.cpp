// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/polygon_irradiance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace etendue::polygon_irradiance_test {
namespace {

using std::numbers::pi;

std::vector<Vec3> square(double half, double height) {
  return {{-half, -half, height}, {half, -half, height}, {half, half, height}, {-half, half, height}};
}

// Each side of a cube fills a sixth of the sphere; all that stands over the horizon fills pi.
TEST(PolygonIrradiance, OfTheSidesOfABoxIsPi) {
  const double top = polygon_irradiance(square(1, 1), Vec3::UnitZ());
  double sides = 0;
  for (int turn = 0; turn < 4; ++turn) {
    std::vector<Vec3> side = square(1, 1);
    const double angle = turn * pi / 2;
    for (Vec3& p : side)
      p = Vec3(std::cos(angle) * p.z() - std::sin(angle) * p.y(),
               std::sin(angle) * p.z() + std::cos(angle) * p.y(), p.x());
    sides += polygon_irradiance(side, Vec3::UnitZ());
  }
  EXPECT_NEAR(top + sides, pi, 1e-14);
  EXPECT_NEAR(triangle_solid_angle({Vec3(1, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, 3)}), pi / 2, 1e-15);
}

TEST(PolygonIrradiance, IsNothingBelowTheHorizonOrEdgeOn) {
  EXPECT_EQ(polygon_irradiance(square(1, 1), -Vec3::UnitZ()), 0);
  EXPECT_NEAR(polygon_irradiance(square(1, 0), Vec3::UnitX()), 0, 1e-15);
}

// Far away it is the area times both cosines over the distance squared.
TEST(PolygonIrradiance, TendsToTheInverseSquare) {
  const Vec3 normal = Vec3(0.3, 0, 1).normalized();
  EXPECT_NEAR(polygon_irradiance(square(0.5, 1000), normal) * 1e6 / normal.z(), 1, 2e-6);
}

// The half of the sphere over a plane tilted by 60 degrees against the square's is cut by the horizon.
TEST(PolygonIrradiance, CountsWhatIsAboveTheHorizon) {
  const Vec3 tilted(std::sin(pi / 3), 0, std::cos(pi / 3));
  const std::vector<Vec3> wide = square(1e6, 1);  // all but a half space
  EXPECT_NEAR(polygon_irradiance(wide, tilted), pi * (1 + std::cos(pi / 3)) / 2, 1e-5);
}

}  // namespace
}  // namespace etendue::polygon_irradiance_test
