// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/exact_family.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/exact/exact_radiance.h"

namespace etendue::exact_family_test {
namespace {

const Vec3 point(0.3, 0.9, 0.6);

TEST(ExactFamily, HasAFormulaWithDerivativesForEveryName) {
  const Vec3 direction = Vec3(1, 2, -2) / 3;
  for (const std::string& name : exact_family_names()) {
    ExactFamily family;
    family.name = name;
    family.degree = 3;
    const ExactRadiance radiance(exact_formula(family));
    EXPECT_GT(radiance.at(point, direction), 0) << name;
    EXPECT_TRUE(std::isfinite(radiance.with_gradient(point, direction).gradient.norm())) << name;
  }
}

TEST(ExactFamily, IsMovedAndScaled) {
  for (const std::string& name : exact_family_names()) {
    ExactFamily family;
    family.name = name;
    const ExactRadiance plain(exact_formula(family));
    family.center = Vec3(-1, 4, 2);
    family.length = 10;
    const ExactRadiance moved(exact_formula(family));
    const Vec3 direction(0.6, 0, 0.8);
    EXPECT_NEAR(moved.at(family.center + 10 * (point - Vec3(0.5, 0.5, 0.5)), direction),
                plain.at(point, direction), 1e-14)
        << name;
  }
}

TEST(ExactFamily, DoesNotChangeAlongADirectionAcrossABorder) {
  for (const char* name : {"jump", "kink", "bend"}) {
    ExactFamily family;
    family.name = name;
    const ExactRadiance radiance(exact_formula(family));
    for (const Vec3& direction : {Vec3(0.6, 0, 0.8), Vec3(0, -1, 0), Vec3(Vec3(1, 1, -1).normalized())}) {
      EXPECT_NEAR(radiance.at(point + 0.37 * direction, direction), radiance.at(point, direction), 1e-14);
      EXPECT_NEAR(radiance.with_gradient(point, direction).gradient.dot(direction), 0, 1e-14) << name;
    }
  }
}

TEST(ExactFamily, HasTheOrderThatItsSmoothnessAllows) {
  const auto order = [](const char* name, int degree, int elements) {
    ExactFamily family;
    family.name = name;
    family.degree = degree;
    return expected_order(family, elements);
  };
  EXPECT_EQ(order("jump", 1, 1), 0.5);
  EXPECT_EQ(order("kink", 1, 1), 1.5);
  EXPECT_EQ(order("kink", 1, 0), 1.0);
  EXPECT_EQ(order("bend", 1, 1), 2.0);
  EXPECT_EQ(order("trigonometric", 1, 1), 2.0);
  EXPECT_EQ(order("polynomial", 1, 1), std::nullopt);
  EXPECT_EQ(order("polynomial", 1, 0), 1.0);
  EXPECT_EQ(order("polynomial", 2, 1), 2.0);
  EXPECT_EQ(order("angular-exponential", 1, 1), std::nullopt);
}

}  // namespace
}  // namespace etendue::exact_family_test
