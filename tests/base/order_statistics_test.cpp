// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/order_statistics.h"

#include <gtest/gtest.h>

namespace etendue::order_statistics_test {
namespace {

TEST(Median, IsInTheMiddleOrAboveIt) {
  EXPECT_EQ(median({5, 1, 3}), 3);
  EXPECT_EQ(median({4, 1, 3, 2}), 3);
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({}), 0);
}

TEST(Quantile, HasItsShareOfTheOthersBelow) {
  const std::vector<double> values = {9, 1, 8, 2, 7, 3, 6, 4, 5, 0, 10};
  EXPECT_EQ(quantile(values, 0), 0);
  EXPECT_EQ(quantile(values, 0.95), 9);
  EXPECT_EQ(quantile(values, 1), 10);
  EXPECT_EQ(quantile({3}, 0.5), 3);
}

}  // namespace
}  // namespace etendue::order_statistics_test
