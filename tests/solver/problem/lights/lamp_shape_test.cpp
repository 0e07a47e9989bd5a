// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/lights/lamp_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace etendue::lamp_shape_test {
namespace {

using std::numbers::pi;

/// 1 + cos(azimuth) on planes of 30 degrees, times 1 + angle.
PointLight lamp() {
  PointLight light;
  light.axis = -Vec3::UnitZ();
  for (int i = 0; i <= 6; ++i) light.angle.push_back(i * pi / 6);
  for (int p = 0; p <= 12; ++p) {
    light.plane.push_back(p * pi / 6);
    for (const double angle : light.angle)
      light.intensity.push_back((1 + std::cos(p * pi / 6)) * (1 + angle));
  }
  return light;
}

TEST(LampShape, IsLinearBetweenPlanesAndAngles) {
  const PointLight light = lamp();
  EXPECT_NEAR(lamp_shape(light, 0.4, 0), 2 * 1.4, 1e-14);
  EXPECT_NEAR(lamp_shape(light, 0.4, pi / 12), (2 + 1 + std::cos(pi / 6)) / 2 * 1.4, 1e-14);
  EXPECT_NEAR(lamp_shape(light, 0.4, -pi / 6), (1 + std::cos(pi / 6)) * 1.4, 1e-13);
  EXPECT_NEAR(lamp_shape(light, Vec3(0, std::sin(0.4), -std::cos(0.4))), 1.4, 1e-13);
  EXPECT_NEAR(lamp_shape(light, Vec3(std::sin(0.4), 0, -std::cos(0.4))), 2 * 1.4, 1e-13);
}

TEST(LampShape, IsDarkBeyondItsPlanesAndAngles) {
  PointLight light = lamp();
  light.plane.resize(4);
  light.intensity.resize(4 * light.angle.size());
  EXPECT_GT(lamp_shape(light, 0.4, pi / 2 - 0.01), 0);
  EXPECT_EQ(lamp_shape(light, 0.4, pi / 2 + 0.01), 0);
  EXPECT_EQ(lamp_shape(light, 0.4, -0.01), 0);
}

// The mean over azimuths of what is linear between planes of equal steps is that of the planes.
TEST(LampShape, HasItsIntegralInClosedForm) {
  EXPECT_NEAR(integral_of_lamp_shape(lamp()), 2 * pi * (2 + pi), 1e-12);
  PointLight even;
  EXPECT_NEAR(integral_of_lamp_shape(even), 4 * pi, 1e-14);
  even.angle = {0, 0.5, 0.5};
  even.intensity = {1, 1, 1};
  EXPECT_NEAR(integral_of_lamp_shape(even), 2 * pi * (1 - std::cos(0.5)), 1e-14);
  EXPECT_EQ(lamp_shape(even, 0.5, 0), 1);
  EXPECT_EQ(lamp_shape(even, 0.51, 0), 0);
}

TEST(LampShape, HasEdgesWhereItJumpsOrBends) {
  const auto edges = [](std::vector<double> angle, std::vector<double> intensity) {
    PointLight light;
    light.angle = std::move(angle);
    light.intensity = std::move(intensity);
    return edges_of_lamp_shape(light);
  };
  using Angles = std::vector<double>;
  EXPECT_EQ(edges({}, {}), Angles());
  EXPECT_EQ(edges({0, pi}, {1, 2}), Angles());
  EXPECT_EQ(edges({0, 0.3, 0.5}, {1, 1, 0}), Angles({0.3, 0.5}));
  EXPECT_EQ(edges({0, 0.5}, {1, 1}), Angles({0.5}));
  EXPECT_EQ(edges({0, 0.5, 0.5, 1}, {2, 2, 1, 0}), Angles({0.5, 1}));
  Angles angle, cosine;
  for (int i = 0; i <= 36; ++i) {
    angle.push_back(i * pi / 36);
    cosine.push_back(2 + std::cos(angle.back()));
  }
  EXPECT_EQ(edges(angle, cosine), Angles());
}

}  // namespace
}  // namespace etendue::lamp_shape_test
