// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/accuracy/convergence_history.h"

#include <gtest/gtest.h>

#include <cmath>

namespace etendue::convergence_history_test {
namespace {

/// Of one number whose value is exact + C h^order.
RefinementChange change_of_power(double coarse, double fine, double order) {
  return {coarse, fine, {3 * (std::pow(fine, order) - std::pow(coarse, order))}};
}

TEST(ConvergenceHistory, ObservesTheOrderWhateverTheSizes) {
  for (const double order : {0.7, 1.0, 1.5, 1.9}) {
    const RefinementChange first = change_of_power(1, 0.7, order), second = change_of_power(0.7, 0.31, order);
    EXPECT_NEAR(observed_order(first, second, 0, 0.5, 2), order, 1e-9) << order;
  }
}

TEST(ConvergenceHistory, KeepsTheOrderWithinItsLimits) {
  EXPECT_DOUBLE_EQ(observed_order(change_of_power(1, 0.5, 3), change_of_power(0.5, 0.25, 3), 0, 0.5, 2), 2);
  // Changes that grow, and none before one.
  EXPECT_DOUBLE_EQ(observed_order({1, 0.5, {0.1}}, {0.5, 0.25, {-0.2}}, 0, 0.5, 2), 0.5);
  EXPECT_DOUBLE_EQ(observed_order({1, 0.5, {0}}, {0.5, 0.25, {0.2}}, 0, 0.5, 2), 0.5);
  // Nothing changes: nothing is wrong.
  EXPECT_DOUBLE_EQ(observed_order({1, 0.5, {0}}, {0.5, 0.25, {0}}, 0, 0.5, 2), 2);
}

TEST(ConvergenceHistory, OneChangeCountsThreeTimes) {
  ConvergenceHistory history;
  EXPECT_FALSE(history.is_known());
  history.add(change_of_power(1, 0.5, 2));
  ASSERT_TRUE(history.is_known());
  const std::vector<double> errors = history.errors(0.5, 2);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NEAR(errors[0], 3 * 3 * 0.25, 1e-12);
}

TEST(ConvergenceHistory, MoreChangesCountByTheirOrderAndAQuarterMore) {
  for (const double order : {0.8, 1.0, 2.0}) {
    ConvergenceHistory history;
    history.add(change_of_power(1, 0.6, order));
    history.add(change_of_power(0.6, 0.4, order));
    EXPECT_NEAR(history.errors(0.4, 2).at(0), 1.25 * 3 * std::pow(0.4, order), 1e-9) << order;
    // And at a size that has had no change yet.
    EXPECT_NEAR(history.errors(0.2, 2).at(0), 1.25 * 3 * std::pow(0.2, order), 1e-9) << order;
  }
}

// A value may pass the right one between two sizes: the change before it bounds what is to be expected.
TEST(ConvergenceHistory, AChangeThatIsSmallByChanceIsNotBelieved) {
  ConvergenceHistory history;
  history.add({1, 0.5, {0.4}});
  history.add({0.5, 0.25, {1e-9}});
  // 0.4 / (2^2 - 1) at 0.5, a quarter of that at 0.25; half of it counts.
  EXPECT_NEAR(history.errors(0.25, 2).at(0), 1.25 * 0.4 / 3 / 4 / 2, 1e-9);
}

TEST(ConvergenceHistory, SizesThatAreNearlyTheSameTellNothingAlone) {
  ConvergenceHistory history;
  history.add({1, 0.9, {0.5}});
  EXPECT_FALSE(history.is_known());
  history.add({0.9, 0.5, {-0.2}});
  ASSERT_TRUE(history.is_known());
  EXPECT_NEAR(history.errors(0.5, 2).at(0), 3 * 0.3 / 3, 1e-12);
}

}  // namespace
}  // namespace etendue::convergence_history_test
