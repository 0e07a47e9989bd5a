// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/phase_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/materials/phase/phase_models.h"
#include "tests/support/text.h"

namespace etendue::phase_table_test {
namespace {

using std::numbers::pi;

/// Henyey and Greenstein's function at angles that crowd in the forward direction.
PhaseTable forward_table(double g, int count, double factor) {
  std::vector<double> cosines = {1}, values = {factor * value_of(PhaseHenyeyGreenstein{g}, 1)};
  for (int i = 0; i <= count; ++i) {
    const double angle = pi * std::pow(10.0, 6.0 * (i - count) / count);
    cosines.push_back(i == count ? -1 : 1 - 2 * std::pow(std::sin(angle / 2), 2));
    values.push_back(factor * value_of(PhaseHenyeyGreenstein{g}, cosines.back()));
  }
  return PhaseTable(cosines, values);
}

TEST(PhaseTable, DividesByItsTrapezoidIntegral) {
  const PhaseTable table({-1, 0, 1}, {2, 2, 2});
  EXPECT_NEAR(table.integral(), 8 * pi, 1e-13);
  EXPECT_NEAR(table.value(0.3), 1 / (4 * pi), 1e-16);
  EXPECT_NEAR(table.moment(1), 0, 1e-16);
}

TEST(PhaseTable, IsLinearBetweenItsCosines) {
  const PhaseTable table({1, 0, -1}, {3, 1, 1});  // falling: as angles rise
  EXPECT_NEAR(table.integral(), 6 * pi, 1e-13);
  EXPECT_DOUBLE_EQ(table.value(0.5), 2 / (6 * pi));
  EXPECT_DOUBLE_EQ(table.value(1), 3 / (6 * pi));
  EXPECT_DOUBLE_EQ(table.value(1 + 1e-16), 3 / (6 * pi));
  EXPECT_DOUBLE_EQ(table.value(-1), 1 / (6 * pi));
}

TEST(PhaseTable, HasTheExactMomentsOfAStraightLine) {
  // (1 + mu) / (4 pi): chi_1 = 1/3 and nothing beyond, at any degree.
  const PhaseTable table({-1, 1}, {0, 1});
  EXPECT_NEAR(table.moment(1), 1.0 / 3, 1e-15);
  for (const int degree : {2, 5, 8}) EXPECT_NEAR(table.moment(degree), 0, 1e-15) << degree;
  for (const int degree : {9, 16, 17, 40}) EXPECT_NEAR(table.moment(degree), 0, 1e-9) << degree;
}

TEST(PhaseTable, ResolvesAForwardPeakOnLogarithmicAngles) {
  const PhaseTable table = forward_table(0.95, 2000, 3);
  EXPECT_NEAR(table.integral(), 3, 1e-4);
  for (const int degree : {1, 2, 7, 30}) EXPECT_NEAR(table.moment(degree), std::pow(0.95, degree), 3e-5);
}

TEST(PhaseTable, KnowsWhatIsNoPhaseFunction) {
  EXPECT_EQ(table_problem({-1, 0, 1}, {1, 2, 3}), "");
  EXPECT_EQ(table_problem({1, -1}, {1, 2}), "");
  EXPECT_TRUE(has(table_problem({1}, {1}), "fewer than two rows"));
  EXPECT_TRUE(has(table_problem({-1, 0.5, 0, 1}, {1, 1, 1, 1}), "must rise or fall"));
  EXPECT_TRUE(has(table_problem({-1, 0, 0, 1}, {1, 1, 1, 1}), "must rise or fall"));
  EXPECT_TRUE(has(table_problem({0, 90, 180}, {1, 1, 1}), "from 0 to 180"));
  EXPECT_TRUE(has(table_problem({-1, 0, 1}, {1, -2, 1}), "p = -2 at mu = 0 is negative"));
  EXPECT_TRUE(has(table_problem({-1, 1}, {0, 0}), "zero throughout"));
}

TEST(PhaseTable, TellsItsFactor) {
  EXPECT_EQ(name_of(PhaseTable({-1, 1}, {0, 1})),
            "table of 2 cosines, divided by its integral 6.28319, g = 0.3333");
}

}  // namespace
}  // namespace etendue::phase_table_test
