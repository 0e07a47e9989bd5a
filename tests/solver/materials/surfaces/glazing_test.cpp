// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/surfaces/glazing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace etendue::glazing_test {
namespace {

using std::numbers::pi;

const double sixty = std::cos(pi / 3);

// Duffie and Beckman, Solar Engineering of Thermal Processes, example 5.1.2: two covers that absorb nothing,
// 0.85 at normal incidence and 0.76 at 60 degrees.
TEST(Glazing, HasTheTransmittanceOfTwoClearCovers) {
  const Glazing covers(Glazing::clear_transmittance(1.526, 2), 1.526, 2);
  EXPECT_NEAR(covers.transmittance(1), 0.85, 5e-3);
  EXPECT_NEAR(covers.transmittance(sixty), 0.76, 5e-3);
}

// Their equation 5.1.8 for N covers: the mean over both polarizations of (1 - r)/(1 + (2N - 1) r).
TEST(Glazing, HasTheClosedFormOfClearPanes) {
  for (const int panes : {1, 2, 3}) {
    const Glazing glass(Glazing::clear_transmittance(1.5, panes), 1.5, panes);
    for (const double degrees : {0.0, 30.0, 60.0, 85.0}) {
      const double outside = degrees * pi / 180, inside = std::asin(std::sin(outside) / 1.5);
      const auto square = [](double x) { return x * x; };
      const double s = degrees > 0 ? square(std::sin(inside - outside) / std::sin(inside + outside)) : 0.04;
      const double p = degrees > 0 ? square(std::tan(inside - outside) / std::tan(inside + outside)) : 0.04;
      const auto passed = [&](double r) { return (1 - r) / (1 + (2 * panes - 1) * r); };
      EXPECT_NEAR(glass.transmittance(std::cos(outside)), (passed(s) + passed(p)) / 2, 1e-12)
          << panes << " panes, " << degrees;
    }
  }
}

// A pane that absorbs, by the sum over the reflections within it of each polarization.
TEST(Glazing, AbsorbsAlongTheRefractedPath) {
  const double index = 1.526, depth = 0.3, normal = std::pow((index - 1) / (index + 1), 2);
  const auto series = [](double r, double passed) {
    double sum = 0, left = (1 - r) * passed;
    for (int i = 0; i < 200; ++i) {
      sum += left * (1 - r);
      left *= r * r * passed * passed;
    }
    return sum;
  };
  const Glazing glass(series(normal, std::exp(-depth)), index);
  for (const double cosine : {1.0, 0.8, sixty, 0.1}) {
    const double inside = std::sqrt(1 - (1 - cosine * cosine) / (index * index));
    const double passed = std::exp(-depth / inside);
    const double s = std::pow((cosine - index * inside) / (cosine + index * inside), 2);
    const double p = std::pow((index * cosine - inside) / (index * cosine + inside), 2);
    EXPECT_NEAR(glass.transmittance(cosine), (series(s, passed) + series(p, passed)) / 2, 1e-12) << cosine;
  }
}

TEST(Glazing, LosesNothingThatItDoesNotAbsorb) {
  const Glazing clear(Glazing::clear_transmittance(1.526, 3), 1.526, 3);
  for (const double cosine : {1.0, 0.5, 0.05})
    EXPECT_NEAR(clear.transmittance(cosine) + clear.reflectance(cosine), 1, 1e-12);
}

TEST(Glazing, HasTheNormalTransmittanceThatItIsGiven) {
  for (const double wanted : {0.05, 0.5, 0.78})
    EXPECT_NEAR(Glazing(wanted, 1.526, 2).transmittance(1), wanted, 1e-12);
}

// The diffuse transmittance, by the midpoint rule in the angle: 2 times the integral of T sin cos.
TEST(Glazing, HasTheMeanOverTheHemisphere) {
  const Glazing glass(0.8);
  double sum = 0;
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double angle = (i + 0.5) * pi / 2 / steps;
    sum += pi / steps * glass.transmittance(std::cos(angle)) * std::sin(angle) * std::cos(angle);
  }
  EXPECT_NEAR(glass.diffuse_transmittance(), sum, 1e-7);
}

}  // namespace
}  // namespace etendue::glazing_test
