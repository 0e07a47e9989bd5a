// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/phase_sampler.h"

#include <gtest/gtest.h>

#include <cmath>

namespace etendue::phase_sampler_test {
namespace {

std::vector<PhaseFunction> functions() {
  const PhaseTable table({-1, -0.5, 0.3, 0.9, 0.99, 1}, {0.2, 0.1, 0.3, 1, 4, 9});
  return {PhaseIsotropic{},
          PhaseRayleigh{},
          PhaseHenyeyGreenstein{0},
          PhaseHenyeyGreenstein{1e-5},
          PhaseHenyeyGreenstein{0.9},
          PhaseHenyeyGreenstein{-0.5},
          PhaseDoubleHenyeyGreenstein{0.8, -0.3, 0.9},
          PhaseCornetteShanks{0.6},
          PhaseLegendre{{1, 0.3, 0.2, 0.1}},
          table,
          PhaseMixture{{0.25, 0.75}, {PhaseRayleigh{}, table}},
          in_plane(PhaseHenyeyGreenstein{0.7}),
          in_plane(table)};
}

TEST(PhaseSampler, DrawsTheMomentsOfTheFunction) {
  constexpr int draws = 20000;  // at equal distances: the midpoint rule over u
  for (const PhaseFunction& phase : functions()) {
    const PhaseSampler sampler(phase);
    const bool plane = std::holds_alternative<PhasePlane>(phase);
    for (unsigned l = 1; l <= 4; ++l) {
      double sum = 0;
      for (int i = 0; i < draws; ++i) {
        const double mu = sampler.cosine((i + 0.5) / draws);
        sum += plane ? std::cos(l * std::acos(mu)) : std::legendre(l, mu);
      }
      EXPECT_NEAR(sum / draws, phase_moment(phase, static_cast<int>(l)), 2e-6) << phase_name(phase) << l;
    }
  }
}

TEST(PhaseSampler, FollowsALongSeriesInAMixture) {
  // A peak of 0.005 radians: 1,500 moments of exp(-l (l + 1)/400^2), half of the light.
  PhaseLegendre peak{{}};
  for (int l = 0; l < 1500; ++l) peak.moments.push_back(std::exp(-l * (l + 1.0) / (400.0 * 400.0)));
  const PhaseSampler sampler(PhaseMixture{{0.5, 0.5}, {PhaseIsotropic{}, peak}});
  // The share of the peak beyond the angle t is exp(-(200 t)^2) where angles are small.
  for (const double share : {0.2, 0.5, 0.8}) {
    const double angle = std::acos(sampler.cosine(0.5 + 0.5 * share));
    EXPECT_NEAR(angle, std::sqrt(-std::log(share)) / 200, 2e-6);
  }
}

TEST(PhaseSampler, RisesFromBackwardToForward) {
  for (const PhaseFunction& phase : functions()) {
    const PhaseSampler sampler(phase);
    EXPECT_NEAR(sampler.cosine(0), -1, 1e-12) << phase_name(phase);
    EXPECT_NEAR(sampler.cosine(1), 1, 1e-12) << phase_name(phase);
    double before = -1;
    for (int i = 1; i < 100; ++i) {
      const double mu = sampler.cosine(i / 100.0);
      EXPECT_GT(mu, before) << phase_name(phase);
      before = mu;
    }
  }
}

}  // namespace
}  // namespace etendue::phase_sampler_test
