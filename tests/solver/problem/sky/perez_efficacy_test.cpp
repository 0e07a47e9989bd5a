// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/sky/perez_efficacy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace etendue::perez_efficacy_test {
namespace {

// Worked by hand from table 4 of Perez et al. 1990 for 2 cm of water: overcast with cos Z = 0.5 and Delta =
// 0.2, 97.24 - 0.92 + 6 + 8.91 * 1.609438 = 116.660; clear with cos Z = 0.8 and Delta = 0.1, 152.23 + 0.7
// - 36.216 + 7.98 * 2.302585 = 135.089.
TEST(PerezEfficacy, HasTheValuesOfTheTable) {
  EXPECT_NEAR(diffuse_luminous_efficacy({1, 0.2}, std::acos(0.5)), 116.660, 1e-3);
  EXPECT_NEAR(diffuse_luminous_efficacy({7, 0.1}, std::acos(0.8)), 135.089, 1e-3);
}

// Drier air leaves more infrared, so a sky is less efficacious.
TEST(PerezEfficacy, GrowsWithTheWaterOfTheAir) {
  EXPECT_GT(diffuse_luminous_efficacy({2, 0.2}, 0.8, 4), diffuse_luminous_efficacy({2, 0.2}, 0.8, 1));
}

}  // namespace
}  // namespace etendue::perez_efficacy_test
