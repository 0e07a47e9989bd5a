// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/anderson_mixing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace etendue::anderson_mixing_test {
namespace {

/// Steps of x_i <- rate_i x_i, whose fixed point is 0, until x is below 1e-10.
int steps_to_zero(std::size_t depth) {
  const std::vector<double> rates = {0.9, 0.5, -0.3, 0.7};
  std::vector<double> x(rates.size(), 1), f(rates.size());
  AndersonMixing mixing(std::vector<double>(rates.size(), 1), depth);
  for (int step = 1; step < 1000; ++step) {
    for (std::size_t i = 0; i < x.size(); ++i) f[i] = (rates[i] - 1) * x[i];
    const std::vector<double> change = mixing.step(x, f);
    double largest = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] += change[i];
      largest = std::max(largest, std::abs(x[i]));
    }
    if (largest < 1e-10) return step;
  }
  return 1000;
}

TEST(AndersonMixing, WithoutMemoryIsTheIterationItself) {
  EXPECT_EQ(steps_to_zero(0), static_cast<int>(std::ceil(std::log(1e-10) / std::log(0.9))));
}

TEST(AndersonMixing, SolvesFourLinearEquationsInSixSteps) { EXPECT_LE(steps_to_zero(5), 6); }

TEST(AndersonMixing, StaysWhereItIs) {
  AndersonMixing mixing({1, 1}, 3);
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(mixing.step(std::vector<double>{1, 2}, std::vector<double>{0, 0}), (std::vector<double>{0, 0}));
}

}  // namespace
}  // namespace etendue::anderson_mixing_test
