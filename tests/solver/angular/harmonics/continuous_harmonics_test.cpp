// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/harmonics/continuous_harmonics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace etendue::continuous_harmonics_test {
namespace {

TEST(ContinuousHarmonics, HaveTheValuesOfTheSetOnItsOrdinates) {
  for (const DirectionSet& set :
       {directions_ldfe_sq(1), directions_product(4), directions_triangular(6), directions_flatland(16)}) {
    const ContinuousHarmonics harmonics(set, 5);
    std::vector<double> values(static_cast<std::size_t>(harmonics.count()));
    for (int m = 0; m < set.count(); ++m) {
      harmonics.at(set.direction(OrdinateIndex(m)), values);
      for (int k = 0; k < harmonics.count(); ++k)
        EXPECT_NEAR(values[static_cast<std::size_t>(k)], harmonics.discrete().value(k, OrdinateIndex(m)),
                    1e-10)
            << set.name() << k;
    }
  }
}

TEST(ContinuousHarmonics, AreLinearFunctionsBetweenThemToo) {
  const ContinuousHarmonics harmonics(directions_ldfe_sq(1), 3);
  std::vector<double> values(static_cast<std::size_t>(harmonics.count()));
  const Vec3 direction = Vec3(0.3, -0.5, 0.7).normalized();
  harmonics.at(direction, values);
  EXPECT_NEAR(values[0], 1, 1e-12);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(values[static_cast<std::size_t>(i) + 1], std::sqrt(3) * direction[i], 1e-12);
}

}  // namespace
}  // namespace etendue::continuous_harmonics_test
