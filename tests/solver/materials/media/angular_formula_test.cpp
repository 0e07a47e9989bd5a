// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/media/angular_formula.h"

#include <gtest/gtest.h>

#include <array>

namespace etendue::angular_formula_test {
namespace {

TEST(AngularFormula, KnowsWhetherItDependsOnTheDirection) {
  const AngularFormula formula("x*wx + 2*wz");
  EXPECT_TRUE(formula.depends_on_direction());
  EXPECT_DOUBLE_EQ(formula.at(Vec3(3, 0, 0), Vec3(0.6, 0.8, 0)), 1.8);
  EXPECT_FALSE(AngularFormula("x + y").depends_on_direction());
}

TEST(MeanOverDirections, IsAFormulaOfThePlace) {
  const Expression mean(mean_over_directions("x*(1 + wx)^2 + wy*wz", false), {"x", "y", "z"});
  EXPECT_NEAR(mean(std::array{3.0, 0.0, 0.0}), 3 * (1 + 1.0 / 3), 1e-12);
  const Expression plane(mean_over_directions("wx^2", true), {"x", "y", "z"});
  EXPECT_NEAR(plane(std::array{0.0, 0.0, 0.0}), 0.5, 1e-12);
}

}  // namespace
}  // namespace etendue::angular_formula_test
