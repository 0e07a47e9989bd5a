// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/color/planck_spectrum.h"

#include <gtest/gtest.h>

#include <cmath>

namespace etendue {
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

}  // namespace
}  // namespace etendue
