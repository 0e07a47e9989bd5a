// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/photon_map/disc_area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace etendue::disc_area_test {
namespace {

using std::numbers::pi;

const std::array<Vec3, 3> corner{Vec3(0, 0, 2), Vec3(3, 0, 2), Vec3(0, 3, 2)};

TEST(DiscArea, IsTheDiscInALargeTriangleAndTheTriangleInALargeDisc) {
  EXPECT_NEAR(area_in_disc(corner, {0.8, 0.8, 2}, 0.5), pi * 0.25, 1e-14);
  EXPECT_NEAR(area_in_disc(corner, {5, -4, 2}, 20), 4.5, 1e-13);
  EXPECT_EQ(area_in_disc(corner, {5, 5, 2}, 1), 0);
}

TEST(DiscArea, IsAHalfAtAnEdgeAndAQuarterAtARightAngle) {
  EXPECT_NEAR(area_in_disc(corner, {1, 0, 2}, 0.5), pi * 0.125, 1e-14);
  EXPECT_NEAR(area_in_disc(corner, {0, 0, 2}, 0.5), pi * 0.0625, 1e-14);
}

// Of triangles about a point that cover more than the disc the parts add up to the disc.
TEST(DiscArea, AddsUpOverTriangles) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 top(number(random), number(random), 0), center(number(random), number(random), 0);
    const std::array<Vec3, 4> square{Vec3(-9, -9, 0), Vec3(9, -9, 0), Vec3(9, 9, 0), Vec3(-9, 9, 0)};
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k)
      sum += area_in_disc({square[k], square[(k + 1) % 4], top}, center, 0.7);
    EXPECT_NEAR(sum, pi * 0.49, 1e-12);
  }
}

}  // namespace
}  // namespace etendue::disc_area_test
