// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/blackbody.h"

#include <gtest/gtest.h>

#include <cmath>

namespace etendue::blackbody_test {
namespace {

// Modest, Radiative Heat Transfer, appendix C: F over lambda T [um K] to five digits.
TEST(PlanckFraction, HasTheValuesOfTheTable) {
  const struct {
    double product, fraction;
  } rows[] = {{1000, 0.00032}, {2000, 0.06673}, {5000, 0.63372}, {10000, 0.91416}, {50000, 0.99890}};
  for (const auto& row : rows)
    EXPECT_NEAR(planck_fraction(row.product, 1000), row.fraction, 1e-5) << row.product;
}

// The derivative is Planck's law; on both sides of the argument at which the series change.
TEST(PlanckFraction, GrowsByPlancksLaw) {
  const double kelvin = 3000;
  for (const double nm : {450., 1000., 5000., 9500., 9700., 20000.}) {
    const double x = 1.438776877e7 / (nm * kelvin);
    const double density = 15 / std::pow(M_PI, 4) * std::pow(x, 4) / std::expm1(x) / nm;
    const double step = 1e-3 * nm;
    EXPECT_NEAR((planck_fraction(nm + step, kelvin) - planck_fraction(nm - step, kelvin)) / (2 * step),
                density, 2e-4 * density)
        << nm;
  }
}

// Simpson's rule on 15/pi^4 t^3/(e^t - 1) with 2e5 intervals.
TEST(BlackbodyFraction, IsPlancksIntegral) {
  constexpr double c2 = 1.438776877e7;
  const auto density = [](double t) {
    return t == 0 ? 0 : 15 / std::pow(M_PI, 4) * t * t * t / std::expm1(t);
  };
  for (const double product : {3e5, 1e6, 2.8978e6, 1e7, 2.9e7, 3e8}) {
    const double first = c2 / product, last = 60;
    const int intervals = 200000;
    const double step = (last - first) / intervals;
    double sum = density(first) + density(last);
    for (int i = 1; i < intervals; ++i) sum += (i % 2 == 1 ? 4 : 2) * density(first + i * step);
    EXPECT_NEAR(blackbody_fraction(product), sum * step / 3, 1e-10) << product;
  }
}

TEST(BlackbodyFraction, HasItsDerivative) {
  for (const double product : {1e6, 3e6, 2.8e7, 2.9e7, 2e8}) {
    const double step = 1e-4 * product;
    const double difference =
        (blackbody_fraction(product + step) - blackbody_fraction(product - step)) / (2 * step);
    EXPECT_NEAR(blackbody_fraction_slope(product), difference, 1e-6 * difference) << product;
  }
}

TEST(BlackbodyFraction, IsNothingWhereNothingGlows) {
  EXPECT_EQ(blackbody_fraction(0), 0);
  EXPECT_EQ(blackbody_fraction(-1), 0);
  EXPECT_EQ(blackbody_fraction(1e-300), 0);
  EXPECT_EQ(blackbody_fraction_slope(1), 0);
  EXPECT_TRUE(std::isnan(blackbody_fraction(std::nan(""))));
  EXPECT_NEAR(blackbody_fraction(1e15), 1, 1e-15);
}

}  // namespace
}  // namespace etendue::blackbody_test
