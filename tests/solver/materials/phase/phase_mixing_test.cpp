// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/phase_mixing.h"

#include <gtest/gtest.h>

namespace etendue::phase_mixing_test {
namespace {

TEST(PhaseMixing, MixesMomentsAndValues) {
  const std::vector<PhaseFunction> phases = {
      PhaseHenyeyGreenstein{0.6}, PhaseDoubleHenyeyGreenstein{0.8, -0.3, 0.7}, PhaseRayleigh{},
      PhaseMixture{{0.4, 0.6}, {PhaseIsotropic{}, PhaseHenyeyGreenstein{0.5}}}};
  for (const PhaseFunction& phase : phases) {
    const PhaseFunction mixed = with_isotropic_part(phase, 0.3);
    EXPECT_NEAR(phase_moment(mixed, 0), 1, 1e-15);
    for (int degree = 1; degree < 5; ++degree)
      EXPECT_NEAR(phase_moment(mixed, degree), 0.7 * phase_moment(phase, degree), 1e-15);
    for (const double mu : {-1.0, 0.2, 0.9})
      EXPECT_NEAR(phase_value(mixed, mu),
                  0.7 * phase_value(phase, mu) + 0.3 * phase_value(PhaseIsotropic{}, mu), 1e-14);
    EXPECT_EQ(with_isotropic_part(phase, 0), phase);
    EXPECT_EQ(with_isotropic_part(phase, 1), PhaseFunction(PhaseIsotropic{}));
  }
  EXPECT_EQ(with_isotropic_part(PhaseIsotropic{}, 0.5), PhaseFunction(PhaseIsotropic{}));
}

TEST(PhaseMixing, RefusesThePlane) {
  EXPECT_THROW(with_isotropic_part(in_plane(PhaseHenyeyGreenstein{0.6}), 0.5), std::invalid_argument);
}

}  // namespace
}  // namespace etendue::phase_mixing_test
