// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/quadrature/cone_cubature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace etendue::cone_cubature_test {
namespace {

using std::numbers::pi;

TEST(ConeCubature, IntegratesCosinesOverConesAndTheSphere) {
  const Vec3 axis = Vec3(1, -2, 0.5).normalized();
  for (const double half_angle : {0.02, 0.7, pi / 2, pi}) {
    const Cone cone{axis, half_angle};
    const ConeIntegrals found = integrate_over_cone(
        cone, 2,
        [&](const Vec3& w, std::span<double> values) {
          values[0] = 1;
          values[1] = w.dot(axis) * w.dot(axis);
        },
        1e-10, 100000);
    EXPECT_NEAR(found.values[0] / cone.solid_angle(), 1, 1e-9) << half_angle;
    const double cosine = std::cos(half_angle);
    EXPECT_NEAR(found.values[1] / (2 * pi / 3 * (1 - cosine * cosine * cosine)), 1, 1e-9) << half_angle;
  }
}

// A lamp's edge: the error falls with the directions, and the estimate tells how large it is.
TEST(ConeCubature, KnowsHowFarItIsFromADisc) {
  const Vec3 lamp = Vec3(0.3, 0.2, 0.8).normalized();
  const double edge = 0.95;
  const auto disc = [&](const Vec3& w, std::span<double> values) { values[0] = w.dot(lamp) > edge ? 1 : 0; };
  double last = 1;
  for (const int most : {1000, 8000, 64000}) {
    const ConeIntegrals found = integrate_over_cone({Vec3::UnitZ(), pi / 2}, 1, disc, 1e-9, most);
    const double error = std::abs(found.values[0] - 2 * pi * (1 - edge));
    EXPECT_LE(found.directions, most);
    EXPECT_LT(error, 3 * found.errors[0]);
    EXPECT_LT(found.errors[0], last);
    last = found.errors[0];
  }
  EXPECT_LT(last, 0.01 * 2 * pi * (1 - edge));
}

TEST(ConeCubature, ConeHoldsWhatIsWithinItsAngle) {
  const Cone cone{Vec3::UnitX(), 0.1};
  EXPECT_TRUE(cone.holds({std::cos(0.0999), 0, std::sin(0.0999)}));
  EXPECT_FALSE(cone.holds({std::cos(0.1001), std::sin(0.1001), 0}));
  EXPECT_NEAR(cone.projected_solid_angle(), pi * std::pow(std::sin(0.1), 2), 1e-15);
}

}  // namespace
}  // namespace etendue::cone_cubature_test
