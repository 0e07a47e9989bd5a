// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/temperature_curve.h"

#include <gtest/gtest.h>

namespace etendue::temperature_curve_test {
namespace {

const TemperatureCurve table = TemperatureCurve::Table{{300, 500, 1000}, {2, 4, -1}};
const TemperatureCurve parabola = TemperatureCurve::Polynomial{{1, 0.5, 0.25}, 2, 6};

TEST(TemperatureCurve, IsLinearBetweenTheEntriesOfATable) {
  EXPECT_DOUBLE_EQ(table.at(300), 2);
  EXPECT_DOUBLE_EQ(table.at(350), 2.5);
  EXPECT_DOUBLE_EQ(table.at(500), 4);
  EXPECT_DOUBLE_EQ(table.at(750), 1.5);
  EXPECT_DOUBLE_EQ(table.with_slope_at(350).slope, 0.01);
  EXPECT_DOUBLE_EQ(table.with_slope_at(750).slope, -0.01);
}

TEST(TemperatureCurve, IsAPolynomial) {
  EXPECT_DOUBLE_EQ(parabola.at(4), 7);
  EXPECT_DOUBLE_EQ(parabola.with_slope_at(4).slope, 2.5);
}

TEST(TemperatureCurve, StaysBeyondWhatIsKnown) {
  EXPECT_DOUBLE_EQ(table.at(100), 2);
  EXPECT_DOUBLE_EQ(table.at(2000), -1);
  EXPECT_EQ(table.with_slope_at(100).slope, 0);
  EXPECT_EQ(table.with_slope_at(2000).slope, 0);
  EXPECT_DOUBLE_EQ(parabola.at(0), 3);
  EXPECT_DOUBLE_EQ(parabola.at(100), 13);
  EXPECT_EQ(parabola.with_slope_at(100).slope, 0);
}

TEST(TemperatureCurve, KnowsWhetherItIsConstant) {
  EXPECT_TRUE(TemperatureCurve(3).is_constant());
  EXPECT_DOUBLE_EQ(TemperatureCurve(3).at(1234), 3);
  EXPECT_TRUE(TemperatureCurve(TemperatureCurve::Table{{300, 400}, {5, 5}}).is_constant());
  EXPECT_TRUE(TemperatureCurve(TemperatureCurve::Polynomial{{5, 0}, 300, 400}).is_constant());
  EXPECT_FALSE(table.is_constant());
  EXPECT_FALSE(parabola.is_constant());
}

}  // namespace
}  // namespace etendue::temperature_curve_test
