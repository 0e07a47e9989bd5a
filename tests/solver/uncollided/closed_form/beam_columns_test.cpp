// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/beam_columns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace etendue::beam_columns_test {
namespace {

using Corners = std::array<Vec3, 4>;

double volume_of(const Corners& c) { return std::abs((c[1] - c[0]).cross(c[2] - c[0]).dot(c[3] - c[0])) / 6; }

/// The length is linear over the cross section.
double volume_of(const Column& column, const Vec3& direction) {
  return column.cross_section(direction) * (column.length[0] + column.length[1] + column.length[2]) / 3;
}

// Whatever comes in goes out: columns fill the tetrahedron, and so do their quarters.
TEST(BeamColumns, FillTheTetrahedron) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto place = [&] { return Vec3(number(random), number(random), number(random)); };
  for (int i = 0; i < 500; ++i) {
    const Corners corners{place(), place(), place(), place()};
    const Vec3 direction = place().normalized();
    double whole = 0, quarters = 0;
    for (const Column& column : columns_of(corners, direction)) {
      whole += volume_of(column, direction);
      for (const Column& quarter : column.quarters()) quarters += volume_of(quarter, direction);
      for (const double length : column.length) EXPECT_GE(length, 0);
    }
    EXPECT_NEAR(whole, volume_of(corners), 1e-13);
    EXPECT_NEAR(quarters, whole, 1e-13);
  }
}

// Faces, edges and planes of symmetry along the light.
TEST(BeamColumns, FillTheCornerOfACubeAlongItsAxesAndDiagonals) {
  const Corners corners{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const Vec3 direction = Vec3(x, y, z).normalized();
        double volume = 0;
        for (const Column& column : columns_of(corners, direction)) volume += volume_of(column, direction);
        EXPECT_NEAR(volume, 1. / 6, 1e-14) << direction.transpose();
      }
}

}  // namespace
}  // namespace etendue::beam_columns_test
