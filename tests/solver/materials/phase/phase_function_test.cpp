// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/phase_function.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace etendue::phase_function_test {
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

/// One of each kind, and the mean cosine where a formula is known.
std::vector<PhaseFunction> models() {
  return {PhaseRayleigh{},
          PhaseDoubleHenyeyGreenstein{0.8, -0.5, 0.7},
          PhaseCornetteShanks{0.6},
          PhaseCornetteShanks{-0.3},
          PhaseLegendre{{1, 0.3, 0.1, 0.02}},
          PhaseTable({-1, -0.2, 0.5, 0.9, 1}, {0.1, 0.2, 0.4, 2, 7}),
          PhaseMixture{{0.25, 0.75}, {PhaseRayleigh{}, PhaseHenyeyGreenstein{0.7}}}};
}

TEST(PhaseFunction, OfEveryModelIntegratesToOneAndHasTheMomentsOfItsValues) {
  for (const PhaseFunction& phase : models()) {
    EXPECT_EQ(phase_moment(phase, 0), 1) << phase_name(phase);
    for (const unsigned degree : {0U, 1U, 2U, 3U, 6U, 9U, 20U})
      EXPECT_NEAR(phase_moment(phase, static_cast<int>(degree)), integrated_moment(phase, degree), 1e-6)
          << phase_name(phase) << ", degree " << degree;
    EXPECT_EQ(phase_asymmetry(phase), phase_moment(phase, 1));
  }
}

TEST(PhaseFunction, RayleighsHasOnlyItsSecondMoment) {
  EXPECT_DOUBLE_EQ(phase_value(PhaseRayleigh{}, 1), 2 * phase_value(PhaseRayleigh{}, 0));
  EXPECT_EQ(phase_moment(PhaseRayleigh{}, 1), 0);
  EXPECT_EQ(phase_moment(PhaseRayleigh{}, 2), 0.1);
  EXPECT_EQ(phase_moment(PhaseRayleigh{}, 4), 0);
}

TEST(PhaseFunction, OfCornetteAndShanksHasThePublishedMeanCosineAndRayleighsLimit) {
  for (const double g : {-0.5, 0.2, 0.85})
    EXPECT_NEAR(phase_asymmetry(PhaseCornetteShanks{g}), 3 * g * (4 + g * g) / (5 * (2 + g * g)), 1e-15);
  for (const int degree : {0, 1, 2, 3, 4})
    EXPECT_NEAR(phase_moment(PhaseCornetteShanks{0}, degree), phase_moment(PhaseRayleigh{}, degree), 1e-16);
}

TEST(PhaseFunction, OfAMixtureIsTheMeanOfItsParts) {
  const PhaseMixture mixture = {{0.25, 0.75}, {PhaseRayleigh{}, PhaseHenyeyGreenstein{0.7}}};
  EXPECT_DOUBLE_EQ(phase_value(mixture, 0.3), 0.25 * phase_value(PhaseRayleigh{}, 0.3) +
                                                  0.75 * phase_value(PhaseHenyeyGreenstein{0.7}, 0.3));
  EXPECT_DOUBLE_EQ(phase_moment(mixture, 2), 0.25 * 0.1 + 0.75 * 0.49);
}

TEST(PhaseFunction, HasAName) {
  EXPECT_EQ(phase_name(PhaseRayleigh{}), "rayleigh");
  EXPECT_EQ(phase_name(PhaseDoubleHenyeyGreenstein{0.8, -0.5, 0.7}),
            "double-henyey-greenstein, g1 = 0.8, g2 = -0.5, weight = 0.7");
  EXPECT_EQ(phase_name(PhaseCornetteShanks{0.6}), "cornette-shanks, g = 0.6");
  EXPECT_EQ(phase_name(PhaseMixture{{0.25, 0.75}, {PhaseRayleigh{}, PhaseHenyeyGreenstein{0.7}}}),
            "mixture of 0.25 (rayleigh) + 0.75 (henyey-greenstein, g = 0.7)");
  EXPECT_EQ(phase_name(PhaseIsotropic{}), "isotropic");
  EXPECT_EQ(phase_name(PhaseHenyeyGreenstein{0.6}), "henyey-greenstein, g = 0.6");
}

}  // namespace
}  // namespace etendue::phase_function_test
