// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/values/mixture_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "app/case/values/gray_gases.h"
#include "app/case/values/value_algebra.h"

namespace etendue::mixture_values_test {
namespace {

double at(const Value& value, double x, double y) {
  if (is_number(value)) return std::get<double>(value);
  return Expression(std::get<Formula>(value), {"x", "y"})(std::array{x, y});
}

// Numbers and formulas are those of a mixture that is the same everywhere.
TEST(MixtureValues, AreThoseOfTheWholeMixture) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> ratios(0, 5), temperatures(250, 2500);
  for (int trial = 0; trial < 200; ++trial) {
    const double ratio = ratios(random), kelvin = temperatures(random);
    const GrayGases mixture = bordbar_gases(std::clamp(ratio, 0.01, 4.0));
    ASSERT_EQ(mixture.gases.size(), 5u);
    for (int gas = 0; gas < 5; ++gas) {
      const GrayGas& exact = mixture.gases[static_cast<std::size_t>(gas)];
      const double absorption = exact.absorption.at(kelvin), weight = exact.weight.at(kelvin);
      EXPECT_NEAR(at(bordbar_absorption(gas, ratio), 0, 0), absorption, 1e-11 * absorption);
      EXPECT_NEAR(at(bordbar_absorption(gas, Formula("x")), ratio, 0), absorption, 1e-11 * absorption);
      EXPECT_TRUE(is_number(bordbar_weight(gas, ratio, kelvin)));
      EXPECT_NEAR(at(bordbar_weight(gas, ratio, kelvin), 0, 0), weight, 1e-12);
      EXPECT_NEAR(at(bordbar_weight(gas, Formula("x"), kelvin), ratio, 0), weight, 1e-12);
      EXPECT_NEAR(at(bordbar_weight(gas, ratio, Formula("y")), 0, kelvin), weight, 1e-12);
      EXPECT_NEAR(at(bordbar_weight(gas, Formula("x"), Formula("y")), ratio, kelvin), weight, 1e-12);
    }
  }
}

}  // namespace
}  // namespace etendue::mixture_values_test
