// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/sky/perez_sky.h"

#include <gtest/gtest.h>

#include <cmath>

namespace etendue::perez_sky_test {
namespace {

double radians(double degrees) { return degrees * M_PI / 180; }

// Worked by hand: Z = 60 degrees, so 1.041 Z^3 = 1.19547; Kasten's air mass 1/(0.5 + 0.15 33.885^-1.253)
// = 1.9928.
TEST(PerezSky, KnowsTheConditionsOfTwoIrradiances) {
  const SkyConditions clear = sky_conditions(800, 100, radians(60));
  EXPECT_NEAR(clear.clearness, (9 + 1.19547) / 2.19547, 1e-4);
  EXPECT_NEAR(clear.brightness, 100 * 1.9928 / 1367, 1e-4);
  const SkyConditions overcast = sky_conditions(0, 200, radians(60));
  EXPECT_EQ(overcast.clearness, 1);
  EXPECT_NEAR(sky_conditions(0, 200, radians(60), 1.03).brightness, overcast.brightness / 1.03, 1e-12);
}

// Worked by hand from table 1 of Perez et al. 1993: bin 8, Z = 1, Delta = 0.1.
TEST(PerezSky, HasTheCoefficientsOfAClearSky) {
  const SkyShape sky = perez_sky({7, 0.1}, 1);
  EXPECT_NEAR(sky.a, -1.05 + 0.0289 + 0.1 * (0.426 + 0.359), 1e-12);
  EXPECT_NEAR(sky.b, -0.325 + 0.1156 + 0.1 * (0.7781 + 0.0025), 1e-12);
  EXPECT_NEAR(sky.c, 31.0625 - 14.5 + 0.1 * (-46.1148 + 55.375), 1e-12);
  EXPECT_NEAR(sky.d, -7.2312 + 0.405 + 0.1 * (13.35 + 0.6234), 1e-12);
  EXPECT_NEAR(sky.e, 1.5 - 0.6426 + 0.1 * (1.8564 + 0.5636), 1e-12);
}

// The same of bin 1, where c and d are exponentials; b is negative and the zenith brighter than the horizon,
// as under clouds.
TEST(PerezSky, OfOvercastSkiesIsBrightestAtTheZenith) {
  const SkyShape sky = perez_sky({1, 0.3}, 1);
  EXPECT_NEAR(sky.c, std::exp(std::pow(0.3 * (2.8 + 0.6004), 1.2375)) - 1, 1e-12);
  EXPECT_NEAR(sky.d, -std::exp(0.3 * (1.8734 + 0.6297)) + 0.9738 + 0.3 * 0.2809, 1e-12);
  EXPECT_GT(sky.radiance(0, 1), 1.5 * sky.radiance(radians(85), radians(90)));
}

TEST(PerezSky, OfClearSkiesIsBrightestAroundTheSun) {
  const SkyShape sky = perez_sky({7, 0.1}, 1);
  EXPECT_GT(sky.radiance(1, 0), 5 * sky.radiance(0, 1));
  EXPECT_GT(sky.radiance(radians(85), radians(90)), sky.radiance(0, 1));
}

// The erratum: between overcast and clear the brightness counts as 0.2 at least.
TEST(PerezSky, TakesDarkSkiesBetweenForBrighter) {
  EXPECT_EQ(perez_sky({2, 0.05}, 1).a, perez_sky({2, 0.2}, 1).a);
  EXPECT_NE(perez_sky({3, 0.05}, 1).a, perez_sky({3, 0.2}, 1).a);
}

}  // namespace
}  // namespace etendue::perez_sky_test
