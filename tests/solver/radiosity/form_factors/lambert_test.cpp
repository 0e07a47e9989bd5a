// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/form_factors/lambert.h"

#include <gtest/gtest.h>

#include <numbers>

namespace etendue::lambert_test {
namespace {

constexpr double pi = std::numbers::pi;

// validation/reference/irradiance.csv, lambert_polygon and rect_source_corner: irradiance of radiance 1.
TEST(Lambert, IrradianceOfPolygonsIsThatOfTheTable) {
  const std::vector<Vec3> triangle = {{-1, -1, 1}, {0, 1, 2}, {1, -1, 1}};
  EXPECT_NEAR(pi * point_factor(Vec3::Zero(), Vec3::UnitZ(), triangle), 0.785225598802, 1e-11);
  const std::vector<Vec3> rectangle = {{0, 0, 1}, {0, 3, 1}, {2, 3, 1}, {2, 0, 1}};
  EXPECT_NEAR(pi * point_factor(Vec3::Zero(), Vec3::UnitZ(), rectangle), 0.683532669111, 1e-11);
}

TEST(Lambert, SurfacesBehindTheHorizonOrSeenFromBehindGiveNothing) {
  const std::vector<Vec3> front = {{-1, -1, 1}, {0, 1, 1}, {1, -1, 1}};
  const std::vector<Vec3> behind = {front[0], front[2], front[1]};
  EXPECT_GT(point_factor(Vec3::Zero(), Vec3::UnitZ(), front), 0);
  EXPECT_EQ(point_factor(Vec3::Zero(), Vec3::UnitZ(), behind), 0);
  EXPECT_EQ(point_factor(Vec3::Zero(), -Vec3::UnitZ(), front), 0);
}

// A wall that goes on below the horizon counts as the part above it.
TEST(Lambert, ThePartBelowTheHorizonDoesNotCount) {
  const std::vector<Vec3> whole = {{1, 0, -1}, {1, 0, 1}, {1, 1, 1}, {1, 1, -1}};
  const std::vector<Vec3> above = {{1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}};
  EXPECT_NEAR(point_factor(Vec3::Zero(), Vec3::UnitZ(), whole),
              point_factor(Vec3::Zero(), Vec3::UnitZ(), above), 1e-15);
}

// The faces of a tetrahedron seen from inside: all directions, and their sum is zero.
TEST(Lambert, AClosedSurfaceTakesAllDirections) {
  const std::array<Vec3, 4> corner = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  const std::array<std::array<std::size_t, 3>, 4> faces = {{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  const Vec3 point(0.2, 0.1, 0.3);
  double angle = 0;
  Vec3 sum = Vec3::Zero();
  for (const auto& face : faces) {
    const TriangleCorners t = {corner[face[0]], corner[face[1]], corner[face[2]]};
    angle += solid_angle(point, t);
    sum += lambert_vector(point, t);
  }
  EXPECT_NEAR(angle, 4 * pi, 1e-13);
  EXPECT_NEAR(sum.norm(), 0, 1e-13);
}

TEST(Lambert, VectorOfASmallPatchIsItsSolidAngleTimesItsDirection) {
  const TriangleCorners t = {Vec3(3, 4, 12), Vec3(3, 4.001, 12), Vec3(3.001, 4, 12)};
  const Vec3 vector = lambert_vector(Vec3::Zero(), t);
  EXPECT_NEAR(vector.norm() / solid_angle(Vec3::Zero(), t), 1, 1e-6);
  EXPECT_NEAR(vector.normalized().dot(Vec3(3, 4, 12) / 13), 1, 1e-6);
}

}  // namespace
}  // namespace etendue::lambert_test
