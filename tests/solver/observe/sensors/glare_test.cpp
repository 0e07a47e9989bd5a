// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/sensors/glare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace etendue::glare_test {
namespace {

using std::numbers::pi;

const LineOfSight ahead{Vec3::UnitX(), Vec3::UnitZ()};

/// Where a source stands, by its distance aside and above over that ahead.
Vec3 place(double aside, double above) { return Vec3(1, aside, above).normalized(); }

// CIE 117:1995, table 4.1, the row T/R = 0 (sources straight above the line of sight). Levin (1975) states 12
// percent between his formula and Guth's curves; here it stays within 4.
TEST(GuthPositionIndex, IsThatOfTheTableAboveTheLineOfSight) {
  for (const auto& [height, index] : {std::pair{0.0, 1.00},
                                      {0.1, 1.26},
                                      {0.2, 1.53},
                                      {0.3, 1.90},
                                      {0.4, 2.35},
                                      {0.5, 2.86},
                                      {0.6, 3.50},
                                      {0.7, 4.20},
                                      {0.8, 5.00},
                                      {0.9, 6.00},
                                      {1.0, 7.00},
                                      {1.2, 9.25},
                                      {1.5, 13.15}})
    EXPECT_NEAR(guth_position_index(ahead, place(0, height)) / index, 1, 0.04) << height;
}

TEST(GuthPositionIndex, IsTheSameOnBothSides) {
  EXPECT_NEAR(guth_position_index(ahead, place(0.7, 0.3)), guth_position_index(ahead, place(-0.7, 0.3)),
              1e-12);
}

// Iwata and others (1997): 1 + 0.8 R/D, and 1 + 1.2 R/D from R = 0.6 D on.
TEST(GuthPositionIndex, IsLinearBelowTheLineOfSight) {
  EXPECT_NEAR(guth_position_index(ahead, place(0.3, -0.4)), 1.4, 1e-12);
  EXPECT_NEAR(guth_position_index(ahead, place(0.6, -0.8)), 2.2, 1e-12);
  EXPECT_NEAR(guth_position_index(ahead, place(0, -10)), 4.6, 1e-12);
}

// By hand: one source of 10,000 cd/m^2 and 0.01 sr on the line of sight, L_b = 40 cd/m^2: 0.25/40 1e8 0.01 =
// 6250, 8 lg 6250 = 30.367; and four of them 8 lg 4 = 4.816 more.
TEST(UnifiedGlareRating, FollowsFromItsFormula) {
  const GlareSource lamp{Vec3::UnitX(), 10000, 0.01, 1};
  EXPECT_NEAR(unified_glare_rating(std::vector{lamp}, 40), 30.367, 1e-3);
  EXPECT_NEAR(unified_glare_rating(std::vector{lamp, lamp, lamp, lamp}, 40), 35.183, 1e-3);
  EXPECT_EQ(unified_glare_rating({}, 40), 0);
}

// By hand: E_v = 3000 lx and a window of 5000 cd/m^2, 0.5 sr and p = 2: 0.1761 + 0.0918 lg(1 +
// 3.125e6/3000^1.87) + 0.16, with 3000^1.87 = 3.1785e6: 0.1761 + 0.0918 lg 1.98318 + 0.16 = 0.36339.
TEST(DaylightGlareProbability, FollowsFromItsFormula) {
  const GlareSource window{Vec3::UnitX(), 5000, 0.5, 2};
  EXPECT_NEAR(daylight_glare_probability(std::vector{window}, 3000), 0.36339, 2e-5);
  EXPECT_EQ(daylight_glare_probability(std::vector{window}, 1e5), 1);
}

// evalglare: below 1000 lx times e^x/(1 + e^x) with x = 0.024 E_v - 4; at 100 lx e^-1.6/(1 + e^-1.6) =
// 0.16798.
TEST(DaylightGlareProbability, IsLessInDimLight) {
  EXPECT_NEAR(daylight_glare_probability({}, 100), 0.16798 * (5.87e-3 + 0.16), 1e-6);
}

/// A view of a small field, all of it about the line of sight, with two bright blocks.
struct Field {
  static constexpr int across = 20;
  std::vector<Vec3> directions;
  std::vector<double> solid_angle, luminance;

  Field() {
    for (int row = 0; row < across; ++row)
      for (int column = 0; column < across; ++column) {
        directions.push_back(place(0.01 * (9.5 - column), 0.01 * (9.5 - row)));
        solid_angle.push_back(1e-4);
        const bool first = row >= 2 && row < 5 && column >= 2 && column < 5;
        const bool second = row >= 12 && row < 14 && column >= 14 && column < 18;
        luminance.push_back(first ? 3000 : second ? 5000 : 100);
      }
  }
  LuminanceView view() const { return {across, directions, solid_angle, luminance}; }
  std::vector<char> bright() const {
    std::vector<char> result;
    for (const double value : luminance) result.push_back(value > 2000 ? 1 : 0);
    return result;
  }
};

TEST(GlareSources, AreGroupsOfBrightPixels) {
  const Field field;
  const auto sources = glare_sources(field.view(), field.bright(), ahead, 0);
  ASSERT_EQ(sources.size(), 2U);
  EXPECT_NEAR(sources[0].luminance, 3000, 1e-9);
  EXPECT_NEAR(sources[0].solid_angle, 9e-4, 1e-15);
  EXPECT_LT((sources[0].towards - place(0.065, 0.065)).norm(), 1e-3);
  EXPECT_NEAR(sources[1].luminance, 5000, 1e-9);
  EXPECT_NEAR(sources[1].solid_angle, 8e-4, 1e-15);
}

TEST(GlareSources, AreOneWhereTheyAreNear) {
  const Field field;
  const auto sources = glare_sources(field.view(), field.bright(), ahead, 0.2);
  ASSERT_EQ(sources.size(), 1U);
  EXPECT_NEAR(sources[0].solid_angle, 17e-4, 1e-15);
  EXPECT_NEAR(sources[0].luminance, (9 * 3000 + 8 * 5000) / 17.0, 1e-9);
}

}  // namespace
}  // namespace etendue::glare_test
