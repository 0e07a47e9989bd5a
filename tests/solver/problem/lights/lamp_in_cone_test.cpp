// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/lights/lamp_in_cone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/problem/lights/lamp_shape.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::lamp_in_cone_test {
namespace {

using std::numbers::pi;

class LampInCone : public testing::Test {
 protected:
  TangentCone at(const Vec3& point) const { return TangentCone(mesh_, CellLocator(mesh_).find(point)); }

  TetrahedralMesh mesh_ = cube_mesh(5e-2);
  TangentCone ceiling_ = at({0.4, 0.3, 1}), edge_ = at({0, 0.4, 1}), corner_ = at({0, 0, 0});
};

PointLight tilted_lamp() {
  PointLight light;
  light.axis = Vec3(0.3, -0.5, 0.4).normalized();
  light.angle = {0, pi};
  light.intensity = {1, 1};
  return light;
}

TEST_F(LampInCone, OfAnEvenTableIsTheSolidAngle) {
  PointLight light = tilted_lamp();
  EXPECT_NEAR(integral_of_lamp_shape(light, ceiling_), 2 * pi, 1e-9);
  EXPECT_NEAR(integral_of_lamp_shape(light, edge_), pi, 1e-9);
  EXPECT_NEAR(integral_of_lamp_shape(light, corner_), pi / 2, 1e-9);
  light.plane = {0.3, 2, 2 * pi + 0.3};
  light.intensity = {1, 1, 1, 1, 1, 1};
  light.zero_plane = light.axis.unitOrthogonal();
  light.quarter_plane = light.axis.cross(light.zero_plane);
  EXPECT_NEAR(integral_of_lamp_shape(light, ceiling_), 2 * pi, 1e-9);
}

TEST_F(LampInCone, OfASpotIntoTheRoomIsAllOfIt) {
  PointLight light;
  light.axis = -Vec3::UnitZ();
  light.angle = {0, 0.3, 0.5};
  light.intensity = {1, 1, 0};
  EXPECT_NEAR(integral_of_lamp_shape(light, ceiling_), integral_of_lamp_shape(light), 1e-12);
  light.axis = Vec3::UnitZ();
  EXPECT_EQ(integral_of_lamp_shape(light, ceiling_), 0);
}

TEST_F(LampInCone, OfASpotAlongTheWallIsHalfOfIt) {
  PointLight light;
  light.axis = Vec3(0.6, 0.8, 0);
  light.angle = {0, 0.3, 0.5};
  light.intensity = {1, 1, 0};
  EXPECT_NEAR(integral_of_lamp_shape(light, ceiling_), integral_of_lamp_shape(light) / 2, 1e-10);
}

// The same sums by many points over the half sphere.
TEST_F(LampInCone, OfPlanesThatAWallCutsAgreesWithASum) {
  PointLight light = tilted_lamp();
  light.angle = {0, 1, pi};
  light.plane = {0, 2, 2 * pi};
  light.intensity = {3, 1, 0, 3, 5, 0, 3, 1, 0};
  light.zero_plane = light.axis.unitOrthogonal();
  light.quarter_plane = light.axis.cross(light.zero_plane);
  const int steps = 2000;
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < steps; ++k) {
      const double z = -(i + 0.5) / steps, phi = 2 * pi * (k + 0.5) / steps, s = std::sqrt(1 - z * z);
      sum += 2 * pi / (steps * steps) * lamp_shape(light, Vec3(s * std::cos(phi), s * std::sin(phi), z));
    }
  EXPECT_NEAR(integral_of_lamp_shape(light, ceiling_), sum, 1e-5 * sum);
}

}  // namespace
}  // namespace etendue::lamp_in_cone_test
