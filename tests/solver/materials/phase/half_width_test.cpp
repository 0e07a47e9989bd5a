// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/half_width.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace etendue::half_width_test {
namespace {

TEST(HalfWidth, OfHenyeyGreensteinIsInClosedForm) {
  for (const double g : {0.5, 0.9, 0.99}) {
    // (1 + g^2 - 2 g cos)^(3/2) = 2 (1 - g)^3
    const double cosine = (1 + g * g - std::pow(2, 2. / 3) * (1 - g) * (1 - g)) / (2 * g);
    EXPECT_NEAR(half_width(PhaseHenyeyGreenstein{g}) / std::acos(cosine), 1, 0.02) << g;
  }
  EXPECT_EQ(half_width(PhaseIsotropic{}), std::numbers::pi);
  EXPECT_EQ(half_width(PhaseHenyeyGreenstein{-0.5}), std::numbers::pi);
}

}  // namespace
}  // namespace etendue::half_width_test
