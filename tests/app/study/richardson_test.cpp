// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/study/richardson.h"

#include <gtest/gtest.h>

#include <cmath>

namespace etendue::richardson_test {
namespace {

TEST(Richardson, FindsLimitAndOrderOfAPowerWhateverTheRatios) {
  const std::array<double, 3> sizes = {0.31, 0.17, 0.08};
  for (const double order : {0.5, 1.0, 2.0, 3.7})
    for (const double factor : {2.5, -0.3}) {
      std::array<double, 3> values{};
      for (std::size_t i = 0; i < 3; ++i) values[i] = 1.25 + factor * std::pow(sizes[i], order);
      const auto found = richardson(sizes, values);
      ASSERT_TRUE(found);
      EXPECT_NEAR(found->value, 1.25, 1e-9);
      EXPECT_NEAR(found->order, order, 1e-6);
    }
}

TEST(Richardson, SaysNothingWhereThereIsNoLimit) {
  EXPECT_FALSE(richardson({0.4, 0.2, 0.1}, {1.0, 1.2, 1.1}));  // to and fro
  EXPECT_FALSE(richardson({0.4, 0.2, 0.1}, {1.0, 1.1, 1.3}));  // away
  EXPECT_FALSE(richardson({0.4, 0.2, 0.1}, {1.0, 1.0, 1.0}));
  EXPECT_FALSE(richardson({0.4, 0.4, 0.1}, {1.0, 1.1, 1.15}));
}

}  // namespace
}  // namespace etendue::richardson_test
