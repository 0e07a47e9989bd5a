// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/band_blackbody.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "base/blackbody.h"

namespace etendue::band_blackbody_test {
namespace {

const Bands kSpectrum{{"short", "middle", "long"}, {1, 2500, 6000, 1e9}};

/// A weight that is linear from 500 K to 2400 K.
TemperatureCurve line(double constant, double slope) {
  return TemperatureCurve::Polynomial{{constant, slope}, 500, 2400};
}

/// The same as a table.
TemperatureCurve two_entries(double constant, double slope) {
  return TemperatureCurve::Table{{500, 2400}, {constant + 500 * slope, constant + 2400 * slope}};
}

const Bands kGases{{"clear", "gray"}, {}, {{{0.0, line(0.6, -1e-4)}, {2.0, line(0.4, 1e-4)}}, 500, 2400}};
const Bands kPoints{
    {"gray-1", "gray-2"}, {}, {{{0.0, two_entries(0.6, -1e-4)}, {2.0, two_entries(0.4, 1e-4)}}, 500, 2400}};

TEST(BandBlackbody, AddsUpToTheLawOfStefanAndBoltzmann) {
  for (const Bands& bands : {Bands{}, kSpectrum, kGases, kPoints})
    for (const double kelvin : {300.0, 900.0, 1800.0}) {
      double sum = 0;
      for (int band = 0; band < bands.count(); ++band) sum += band_blackbody(bands, band, kelvin);
      EXPECT_NEAR(sum * std::numbers::pi / (stefan_boltzmann * std::pow(kelvin, 4)), 1, 1e-9);
    }
}

TEST(BandBlackbody, HasTheSlopeOfItsDifferences) {
  std::mt19937 random(3);
  for (const Bands& bands : {Bands{}, kSpectrum, kGases, kPoints})
    for (int draw = 0; draw < 50; ++draw) {
      const double kelvin = std::uniform_real_distribution<double>(510, 2300)(random), step = 1e-3 * kelvin;
      for (int band = 0; band < bands.count(); ++band) {
        const double difference =
            (band_blackbody(bands, band, kelvin + step) - band_blackbody(bands, band, kelvin - step)) /
            (2 * step);
        EXPECT_NEAR(band_blackbody_slope(bands, band, kelvin) / difference, 1, 2e-4) << band << " " << kelvin;
      }
    }
}

TEST(BandBlackbody, KeepsTheWeightsOfGasesBelowTheirFit) {
  for (const Bands& bands : {kGases, kPoints}) {
    for (int band = 0; band < 2; ++band)
      EXPECT_DOUBLE_EQ(band_blackbody(bands, band, 250) * 16, band_blackbody(bands, band, 500));
    EXPECT_DOUBLE_EQ(band_blackbody_slope(bands, 1, 250) * 250, 4 * band_blackbody(bands, 1, 250));
  }
}

}  // namespace
}  // namespace etendue::band_blackbody_test
