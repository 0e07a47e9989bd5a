// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/materials/phase/phase_function.h"

namespace etendue::phase_plane_test {
namespace {

using std::numbers::pi;

std::vector<PhaseFunction> plane_functions() {
  const PhaseTable table({-1, -0.5, 0.3, 0.9, 0.99, 1}, {0.2, 0.1, 0.3, 1, 4, 9});
  return {in_plane(PhaseIsotropic{}),
          in_plane(PhaseRayleigh{}),
          in_plane(PhaseHenyeyGreenstein{0.7}),
          in_plane(PhaseHenyeyGreenstein{-0.4}),
          in_plane(PhaseDoubleHenyeyGreenstein{0.8, -0.3, 0.9}),
          in_plane(PhaseCornetteShanks{0.6}),
          in_plane(PhaseLegendre{{1, 0.3, 0.2, 0.1}}),
          in_plane(table),
          in_plane(PhaseMixture{{0.25, 0.75}, {PhaseRayleigh{}, table}})};
}

/// Integral of p(cos t) cos(k t) over the circle by the midpoint rule, which converges at least as 1/steps^2.
double moment_by_midpoints(const PhaseFunction& phase, int k) {
  constexpr int steps = 20000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = pi * (i + 0.5) / steps;
    sum += phase_value(phase, std::cos(t)) * std::cos(k * t);
  }
  return 2 * sum * pi / steps;
}

TEST(PhasePlane, IntegratesToOneOverTheCircleAndHasTheMomentsOfItsValues) {
  for (const PhaseFunction& phase : plane_functions()) {
    EXPECT_NEAR(phase_moment(phase, 0), 1, 1e-14) << phase_name(phase);
    for (int k = 0; k <= 12; ++k)
      EXPECT_NEAR(phase_moment(phase, k), moment_by_midpoints(phase, k), 1e-7) << phase_name(phase) << k;
  }
}

TEST(PhasePlane, HenyeyGreensteinHasPoissonsKernelAndPowersOfG) {
  const double g = 0.7, mu = 0.3;
  const PhaseFunction phase = in_plane(PhaseHenyeyGreenstein{g});
  EXPECT_DOUBLE_EQ(phase_value(phase, mu), (1 - g * g) / (2 * pi * (1 + g * g - 2 * g * mu)));
  for (int k = 0; k <= 8; ++k) EXPECT_DOUBLE_EQ(phase_moment(phase, k), std::pow(g, k));
}

TEST(PhasePlane, CornetteShanksAtZeroIsRayleigh) {
  const PhaseFunction cornette = in_plane(PhaseCornetteShanks{0}), rayleigh = in_plane(PhaseRayleigh{});
  for (const double mu : {-1.0, -0.3, 0.5, 1.0})
    EXPECT_DOUBLE_EQ(phase_value(cornette, mu), phase_value(rayleigh, mu));
}

TEST(PhasePlane, IsItsOwnPlaneFunction) {
  for (const PhaseFunction& phase : plane_functions()) EXPECT_EQ(in_plane(phase), phase);
}

TEST(PhasePlane, SeriesAreJudgedByTheirValuesInThePlane) {
  // 1 + 3 chi_1 mu + 5 chi_2 (3 mu^2 - 1)/2 is negative near mu = 0, 1 + 2 chi_1 cos t + 2 chi_2 cos 2t is
  // not.
  EXPECT_NE(series_problem({1, 0.1, 0.45}, AngularSpace::sphere), "");
  EXPECT_EQ(series_problem({1, 0.1, 0.45}, AngularSpace::plane), "");
  EXPECT_NE(series_problem({1, 0.6}, AngularSpace::plane).find("per rad"), std::string::npos);
}

}  // namespace
}  // namespace etendue::phase_plane_test
