// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/phase_function.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace etendue {
namespace {

/// 2 pi times the integral of p(mu) P_l(mu) by the midpoint rule in the angle.
double integrated_moment(const PhaseFunction& phase, unsigned degree) {
  constexpr int steps = 20000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double angle = std::numbers::pi * (i + 0.5) / steps;
    sum += phase_value(phase, std::cos(angle)) * std::legendre(degree, std::cos(angle)) * std::sin(angle);
  }
  return 2 * std::numbers::pi * sum * std::numbers::pi / steps;
}

TEST(PhaseFunction, IntegratesToOne) {
  EXPECT_NEAR(integrated_moment(PhaseIsotropic{}, 0), 1, 1e-8);
  for (const double g : {-0.6, 0.0, 0.3, 0.8})
    EXPECT_NEAR(integrated_moment(PhaseHenyeyGreenstein{g}, 0), 1, 1e-6);
}

TEST(PhaseFunction, HasTheLegendreMomentsOfItsValues) {
  for (const double g : {-0.6, 0.3, 0.8}) {
    const PhaseFunction phase = PhaseHenyeyGreenstein{g};
    for (const int degree : {1, 2, 5})
      EXPECT_NEAR(phase_moment(phase, degree), integrated_moment(phase, static_cast<unsigned>(degree)), 1e-6);
    EXPECT_EQ(phase_asymmetry(phase), g);
  }
}

TEST(PhaseFunction, IsotropicIsConstantWithNoHigherMoment) {
  EXPECT_DOUBLE_EQ(phase_value(PhaseIsotropic{}, -0.3), 1 / (4 * std::numbers::pi));
  EXPECT_EQ(phase_moment(PhaseIsotropic{}, 0), 1);
  EXPECT_EQ(phase_moment(PhaseIsotropic{}, 1), 0);
  EXPECT_EQ(phase_asymmetry(PhaseIsotropic{}), 0);
}

TEST(PhaseFunction, HasAName) {
  EXPECT_EQ(phase_name(PhaseIsotropic{}), "isotropic");
  EXPECT_EQ(phase_name(PhaseHenyeyGreenstein{0.6}), "henyey-greenstein, g = 0.6");
}

}  // namespace
}  // namespace etendue
