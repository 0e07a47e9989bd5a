// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/quadrature/gauss_legendre.h"

#include <gtest/gtest.h>

#include <cmath>

namespace etendue::gauss_legendre_test {
namespace {

double integral_of_power(const GaussRule& rule, int power) {
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], power);
  return sum;
}

TEST(GaussLegendre, IntegratesPolynomialsUpToTwiceItsSizeLessOne) {
  for (const int count : {1, 2, 3, 5, 8, 16}) {
    const GaussRule rule = gauss_legendre(count);
    for (int power = 0; power < 2 * count; ++power)
      EXPECT_NEAR(integral_of_power(rule, power), power % 2 ? 0 : 2.0 / (power + 1), 2e-15)
          << count << " points, power " << power;
  }
}

TEST(GaussLegendre, FailsAtTheNextDegree) {
  const GaussRule rule = gauss_legendre(4);
  EXPECT_GT(std::abs(integral_of_power(rule, 8) - 2.0 / 9), 1e-3);
}

TEST(GaussLegendre, HasExactlySymmetricRisingNodes) {
  const GaussRule rule = gauss_legendre(222);
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const std::size_t other = rule.nodes.size() - 1 - i;
    EXPECT_EQ(rule.nodes[i], -rule.nodes[other]);
    EXPECT_EQ(rule.weights[i], rule.weights[other]);
    if (i > 0) {
      EXPECT_GT(rule.nodes[i], rule.nodes[i - 1]);
    }
    sum += rule.weights[i];
  }
  EXPECT_NEAR(sum, 2, 1e-13);
}

}  // namespace
}  // namespace etendue::gauss_legendre_test
