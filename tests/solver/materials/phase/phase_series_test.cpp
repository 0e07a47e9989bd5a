// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/phase_series.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/materials/phase/phase_models.h"
#include "tests/support/text.h"

namespace etendue::phase_series_test {
namespace {

std::vector<double> powers(double g, int count) {
  std::vector<double> moments;
  for (int l = 0; l < count; ++l) moments.push_back(std::pow(g, l));
  return moments;
}

TEST(PhaseSeries, OfPowersIsHenyeyAndGreensteins) {
  const PhaseLegendre series = {powers(0.6, 80)};
  for (const double mu : {-1.0, -0.4, 0.0, 0.7, 1.0})
    EXPECT_NEAR(value_of(series, mu), value_of(PhaseHenyeyGreenstein{0.6}, mu), 1e-13);
  EXPECT_DOUBLE_EQ(moment_of(series, 5), std::pow(0.6, 5));
  EXPECT_EQ(moment_of(series, 80), 0);
}

TEST(PhaseSeries, IsAPhaseFunctionWhereItIsNotNegative) {
  EXPECT_EQ(series_problem({1}), "");
  EXPECT_EQ(series_problem({1, 1.0 / 3}), "");  // 1 + mu
  EXPECT_EQ(series_problem(powers(0.6, 40)), "");
  EXPECT_TRUE(has(series_problem({1, 0.5}), "negative, -0.0398 per sr at mu = -1"))
      << series_problem({1, 0.5});
  EXPECT_TRUE(has(series_problem(powers(0.8, 8)), "use more coefficients"));
}

TEST(PhaseSeries, RefusesWhatAreNoMoments) {
  EXPECT_TRUE(has(series_problem({}), "does not begin with 1"));
  EXPECT_TRUE(has(series_problem({0.5, 0.2}), "does not begin with 1"));
  EXPECT_TRUE(has(series_problem({1, 1.8, 2}), "chi_1 = 1.8 belongs to no phase function"));
  EXPECT_TRUE(has(series_problem({1, 0.5, std::nan("")}), "chi_2"));
}

}  // namespace
}  // namespace etendue::phase_series_test
