// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/sky/sun_position.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace etendue::sun_position_test {
namespace {

// Reda and Andreas, Solar Energy 76 (2004) 577, table A5.1: Golden, Colorado; altitude without
// refraction 39.872046, azimuth 194.340241 degrees.
TEST(SunPosition, IsThatOfThePublishedExample) {
  const SunPosition sun = sun_position({39.742476, -105.1786, -7, 2003, 10, 17, 12 + 30.5 / 60});
  EXPECT_NEAR(sun.altitude - sun.refraction, 39.872046, 0.01);
  EXPECT_NEAR(sun.azimuth, 194.340241, 0.01);
  // At 820 mbar and 11 degrees Celsius 0.016332 degrees; at sea level and 15 degrees more by the density of
  // the air.
  EXPECT_NEAR(sun.refraction, 0.016332 * (1013.2 / 820) * (284.15 / 288.2), 1e-3);
}

// At the June solstice of 2024 (20 June, 20:51 UT) the sun stands over the tropic, 23.4387 degrees north.
TEST(SunPosition, StandsOverTheTropicAtTheSolstice) {
  const SunPosition sun = sun_position({90, 0, 0, 2024, 6, 20, 20.85});
  EXPECT_NEAR(sun.altitude - sun.refraction, 23.4387, 0.01);
}

TEST(SunPosition, RisesInTheEastAndStandsInTheNorthAtNoonInTheSouth) {
  const SunPosition morning = sun_position({0, 0, 0, 2024, 3, 20, 7}),
                    noon = sun_position({-34, 0, 0, 2024, 6, 21, 12});
  EXPECT_NEAR(morning.azimuth, 90, 1);
  EXPECT_LT(std::min(noon.azimuth, 360 - noon.azimuth), 2);
}

// Perihelion in January, at 0.9833 of the mean distance; aphelion in July, at 1.0167.
TEST(SunPosition, TheSunIsNearestInJanuary) {
  EXPECT_NEAR(sun_eccentricity(2024, 1, 3), 1 / (0.9833 * 0.9833), 2e-3);
  EXPECT_NEAR(sun_eccentricity(2024, 7, 5), 1 / (1.0167 * 1.0167), 2e-3);
}

}  // namespace
}  // namespace etendue::sun_position_test
