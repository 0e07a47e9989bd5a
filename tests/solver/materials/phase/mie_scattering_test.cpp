// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/mie_scattering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/quadrature/gauss_legendre.h"
#include "solver/materials/phase/mie_sphere.h"

namespace etendue::mie_scattering_test {
namespace {

using std::numbers::pi;

TEST(MieScattering, OfOneSizeHasTheAsymmetryAndTheValuesOfItsSphere) {
  const std::complex<double> index(1.5, 0.01);
  const MieScattering cloud = mie_scattering(OneSize{3}, index, 2);
  const double x = 2 * pi * 3 / 2;
  const MieSphere sphere(x, index);
  EXPECT_NEAR(moment_of(cloud.phase, 1), sphere.asymmetry(), 1e-12);
  EXPECT_NEAR(cloud.scattering_cross_section, pi * 9 * sphere.scattering(), 1e-10);
  for (const double mu : {-1.0, -0.4, 0.3, 0.9, 0.999, 1.0}) {
    const double expected = sphere.intensity(mu) / (2 * pi * x * x * sphere.scattering());
    EXPECT_NEAR(value_of(cloud.phase, mu), expected, 1e-10 * expected + 1e-12) << mu;
  }
}

TEST(MieScattering, IsAPhaseFunction) {
  for (const Sizes& sizes : {Sizes(OneSize{0.01}), Sizes(OneSize{5}), Sizes(LogNormalSizes{0.3, 1.5}),
                             Sizes(GammaSizes{2, 0.1})}) {
    const MieScattering cloud = mie_scattering(sizes, 1.33, 0.6);
    EXPECT_DOUBLE_EQ(moment_of(cloud.phase, 0), 1);
    EXPECT_EQ(series_problem(cloud.phase.moments), "");
    const GaussRule rule = gauss_legendre(800);
    double sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
      sum += 2 * pi * rule.weights[i] * value_of(cloud.phase, rule.nodes[i]);
    EXPECT_NEAR(sum, 1, 1e-11);
  }
}

TEST(MieScattering, HasTheMeanAreaOfItsDistribution) {
  const double width = std::log(1.5);
  EXPECT_NEAR(mie_scattering(LogNormalSizes{0.3, 1.5}, 1.33, 0.6).area,
              pi * 0.09 * std::exp(2 * width * width), 1e-6);
  EXPECT_NEAR(mie_scattering(GammaSizes{2, 0.1}, 1.33, 0.6).area, pi * 4 * 0.9 * 0.8, 1e-6);
}

TEST(MieScattering, OfANarrowDistributionIsThatOfItsSize) {
  const MieScattering one = mie_scattering(OneSize{0.5}, 1.4, 0.6);
  for (const Sizes& sizes : {Sizes(LogNormalSizes{0.5, 1.0005}), Sizes(GammaSizes{0.5, 2.5e-7})}) {
    const MieScattering narrow = mie_scattering(sizes, 1.4, 0.6);
    EXPECT_NEAR(narrow.scattering_cross_section, one.scattering_cross_section, 1e-4);
    EXPECT_NEAR(moment_of(narrow.phase, 1), moment_of(one.phase, 1), 1e-4);
  }
}

TEST(MieScattering, RefusesWhatItCannotCompute) {
  EXPECT_NE(mie_problem(OneSize{1}, 1.0, 0.5).find("scatters nothing"), std::string::npos);
  EXPECT_NE(mie_problem(OneSize{1000}, 1.3, 0.5).find("too large"), std::string::npos);
  EXPECT_EQ(mie_problem(LogNormalSizes{0.3, 1.5}, 1.3, 0.5), "");
}

}  // namespace
}  // namespace etendue::mie_scattering_test
