// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/angular/harmonics/harmonics.h"
#include "tests/solver/angular/sets/sets_to_test.h"

namespace etendue::scattering_test {
namespace {

TEST(Scattering, KeepsEnergyAndAsymmetryOnEverySet) {
  for (const DirectionSet& set : sets_to_test())
    for (const double g : {-0.5, 0.3, 0.5, 0.7, 0.9, 0.98})
      for (const int degree : {1, 3, 7}) {
        const ScatteringAccuracy accuracy = scattering_accuracy(PhaseHenyeyGreenstein{g}, degree, set);
        EXPECT_LT(accuracy.energy_error, 1e-13) << label(set) << ", g = " << g;
        EXPECT_NEAR(accuracy.asymmetry, g, 1e-12) << label(set);
      }
}

TEST(Scattering, HasAKernelWhoseRowsSumToOneAndTurnByTheAsymmetry) {
  const DirectionSet set = directions_ldfe_sq(1);
  const DiscreteHarmonics harmonics(set, 7);
  const PhaseFunction phase = PhaseHenyeyGreenstein{0.8};
  for (int from = 0; from < set.count(); from += 7) {
    double sum = 0;
    Vec3 mean = Vec3::Zero();
    for (int to = 0; to < set.count(); ++to) {
      double kernel = 0;
      for (int k = 0; k < harmonics.count(); ++k)
        kernel += phase_moment(phase, harmonics.degree_of(k)) * harmonics.value(k, OrdinateIndex(from)) *
                  harmonics.value(k, OrdinateIndex(to)) / (4 * std::numbers::pi);
      sum += set.weight(OrdinateIndex(to)) * kernel;
      mean += set.weight(OrdinateIndex(to)) * kernel * set.direction(OrdinateIndex(to));
    }
    EXPECT_NEAR(sum, 1, 1e-13);
    EXPECT_LT((mean - 0.8 * set.direction(OrdinateIndex(from))).norm(), 1e-13);
  }
}

TEST(Scattering, ConvergesToThePhaseFunctionWithDegree) {
  const DirectionSet set = directions_product(16);
  const PhaseFunction phase = PhaseHenyeyGreenstein{0.3};
  const DiscreteHarmonics harmonics(set, 7);
  for (int to = 0; to < set.count(); to += 11) {
    double kernel = 0;
    for (int k = 0; k < harmonics.count(); ++k)
      kernel += phase_moment(phase, harmonics.degree_of(k)) * harmonics.value(k, OrdinateIndex(4)) *
                harmonics.value(k, OrdinateIndex(to)) / (4 * std::numbers::pi);
    // The truncated part is at most the sum of (2l+1) g^l / 4 pi over l > 7.
    EXPECT_NEAR(kernel,
                phase_value(phase, set.direction(OrdinateIndex(4)).dot(set.direction(OrdinateIndex(to)))),
                1.4e-4);
  }
}

TEST(Scattering, ChoosesTheDegreeByWhatIsLeftOut) {
  const DirectionSet set = directions_ldfe_sq(1);
  const auto degree = [&set](double g) { return scattering_degree(PhaseHenyeyGreenstein{g}, set).degree; };
  EXPECT_EQ(scattering_degree(PhaseIsotropic{}, set).degree, 0);
  EXPECT_EQ(degree(0), 0);
  EXPECT_EQ(degree(0.001), 1);
  EXPECT_EQ(degree(0.3), 3);
  EXPECT_EQ(degree(-0.3), 3);
  EXPECT_EQ(degree(0.5), 5);
  EXPECT_EQ(degree(0.6), 7);
  EXPECT_EQ(degree(0.95), 7);
}

TEST(Scattering, LooksAtAllMomentsBeyondADegree) {
  const DirectionSet set = directions_ldfe_sq(1);
  EXPECT_EQ(scattering_degree(PhaseRayleigh{}, set).degree,
            2);  // the mean cosine is 0, the next moment is not
  EXPECT_EQ(scattering_degree(PhaseDoubleHenyeyGreenstein{0.6, -0.6, 0.5}, set).degree, 6);
  EXPECT_EQ(scattering_degree(PhaseLegendre{{1, 0, 0, 0, 0.05}}, set).degree, 4);
  EXPECT_EQ(scattering_degree(PhaseLegendre{{1}}, set).degree, 0);
  EXPECT_EQ(scattering_degree(PhaseMixture{{1}, {PhaseHenyeyGreenstein{0.5}}}, set).degree, 5);
}

TEST(Scattering, KeepsEnergyAndAsymmetryOfEveryModel) {
  const std::vector<PhaseFunction> models = {
      PhaseRayleigh{},
      PhaseDoubleHenyeyGreenstein{0.8, -0.5, 0.7},
      PhaseCornetteShanks{0.6},
      PhaseLegendre{{1, 0.3, 0.1, 0.02}},
      PhaseTable({-1, -0.2, 0.5, 0.9, 1}, {0.1, 0.2, 0.4, 2, 7}),
      PhaseMixture{{0.25, 0.75}, {PhaseRayleigh{}, PhaseHenyeyGreenstein{0.7}}}};
  for (const DirectionSet& set : {directions_ldfe_sq(1), directions_double_gauss(4),
                                  directions_level_symmetric(8), directions_thurgood(4)})
    for (const PhaseFunction& phase : models) {
      const int degree = scattering_degree(phase, set).degree;
      const ScatteringAccuracy accuracy = scattering_accuracy(phase, degree, set);
      EXPECT_LT(accuracy.energy_error, 1e-12) << phase_name(phase) << " on " << label(set);
      EXPECT_NEAR(accuracy.asymmetry, phase_asymmetry(phase), 1e-10) << phase_name(phase);
    }
}

TEST(Scattering, GivesTheReasonForItsDegree) {
  EXPECT_EQ(scattering_degree(PhaseIsotropic{}, directions_ldfe_sq(1)).reason, "isotropic");
  EXPECT_EQ(scattering_degree(PhaseHenyeyGreenstein{0.5}, directions_ldfe_sq(1)).reason,
            "what is beyond is below 0.02; the moment of degree 6, 0.016, is the first left out");
  EXPECT_EQ(scattering_degree(PhaseHenyeyGreenstein{0.9}, directions_ldfe_sq(1)).reason,
            "the highest used; the moment of degree 8, 0.43, is the first left out");
  EXPECT_EQ(scattering_degree(PhaseHenyeyGreenstein{0.9}, directions_triangular(4)).reason,
            "all that the direction set resolves; the moment of degree 4, 0.66, is the first left out");
}

}  // namespace
}  // namespace etendue::scattering_test
