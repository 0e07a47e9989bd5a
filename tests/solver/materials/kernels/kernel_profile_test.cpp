// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/kernels/kernel_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

namespace etendue::kernel_profile_test {
namespace {

using std::numbers::pi;

/// 2 pi times the integral over cosines, by the midpoint rule over angles.
double integral(const KernelProfile& profile) {
  constexpr int steps = 360;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double angle = pi * (i + 0.5) / steps;
    sum += 2 * pi * std::sin(angle) * profile(std::cos(angle)) * pi / steps;
  }
  return sum;
}

TEST(KernelProfile, IsNormalisedAsAPhaseFunction) {
  const DirectionalScattering level = LeafCanopy{LeafAngles::horizontal, 0.3, 0.2};
  const DirectionalScattering upright = LeafCanopy{LeafAngles::vertical, 0.3, 0.2};
  const DirectionalScattering fibres = MicroFlakes{Vec3(0, 0.6, 0.8), 0.4, 1, 0.9};
  KernelFormula formula;
  formula.formula = std::make_shared<Expression>("2 + wx*vx - vz", kernel_variables());
  const DirectionalScattering general = formula;
  for (const DirectionalScattering* matter : {&level, &upright, &fibres, &general})
    for (const Vec3& before : {Vec3(0, 0, -1), Vec3(0.6, 0, -0.8)}) {
      const KernelProfile profile(*matter, before);
      if (!profile.is_known()) continue;
      EXPECT_NEAR(integral(profile), 1, 2e-3) << directional_name(*matter) << " from " << before.z();
    }
}

TEST(KernelProfile, OfLevelLeavesUnderTheZenithIsLamberts) {
  // Down onto leaves that reflect: |cos|/pi upwards, nothing downwards.
  const DirectionalScattering leaves = LeafCanopy{LeafAngles::horizontal, 0.5, 0};
  const KernelProfile profile(leaves, Vec3(0, 0, -1));
  EXPECT_NEAR(profile(-0.7), 0.7 / pi, 1e-14);
  EXPECT_EQ(profile(0.7), 0);
}

TEST(KernelProfile, OfWhatDoesNotScatterOrIsAMatrixIsUnknown) {
  const DirectionalScattering black = LeafCanopy{LeafAngles::spherical, 0, 0};
  const DirectionalScattering matrix = KernelMatrix{};
  EXPECT_FALSE(KernelProfile(black, Vec3::UnitX()).is_known());
  EXPECT_FALSE(KernelProfile(matrix, Vec3::UnitX()).is_known());
}

}  // namespace
}  // namespace etendue::kernel_profile_test
