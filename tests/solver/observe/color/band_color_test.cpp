// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/color/band_color.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/observe/color/color_matching.h"

namespace etendue::band_color_test {
namespace {

/// Planck's law but for a factor; wavelength in nm.
double planck(double wavelength, double kelvin) {
  constexpr double c2 = 1.438776877e7;  // nm K (CODATA 2018)
  return std::pow(wavelength, -5) / std::expm1(c2 / (wavelength * kelvin));
}

struct Chromaticity {
  double x, y;
};

/// Of a spectrum in 1 nm bands from 380 to 780 nm.
template <class Spectrum>
Chromaticity chromaticity(Spectrum spectrum) {
  std::array<double, 3> xyz{};
  for (int nm = 380; nm <= 780; ++nm) {
    const auto mean = mean_color_matching(nm - 0.5, nm + 0.5);
    for (std::size_t k = 0; k < 3; ++k) xyz[k] += spectrum(nm) * mean[k];
  }
  const double sum = xyz[0] + xyz[1] + xyz[2];
  return {xyz[0] / sum, xyz[1] / sum};
}

// Own sums of the 1 nm table (CIE 1931, c2 = 1.438776877e-2 m K).
TEST(ColorMatching, GivesTheChromaticityOfBlackBodies) {
  const struct {
    double kelvin, x, y;
  } bodies[] = {{2000, 0.52668, 0.41330}, {2856, 0.44754, 0.40743}, {6500, 0.31353, 0.32363}};
  for (const auto& body : bodies) {
    const Chromaticity c = chromaticity([&](double nm) { return planck(nm, body.kelvin); });
    EXPECT_NEAR(c.x, body.x, 1e-4);
    EXPECT_NEAR(c.y, body.y, 1e-4);
  }
  const Chromaticity equal = chromaticity([](double) { return 1.0; });
  EXPECT_NEAR(equal.x, 0.33331, 1e-4);
  EXPECT_NEAR(equal.y, 0.33329, 1e-4);
}

// The common lasers, by the rows of the table of 1 nm: z is 1 - x - y.
TEST(ColorMatching, HasTheChromaticitiesOfSingleWavelengths) {
  struct Line {
    double nm, x, y;
  };
  for (const Line& line : {Line{507, 0.00601, 0.69612},
                           {532, 0.17024, 0.79652},
                           {589, 0.56926, 0.43010},
                           {633, 0.71172, 0.28823}}) {
    const auto mean = mean_color_matching(line.nm - 0.01, line.nm + 0.01);
    const double sum = mean[0] + mean[1] + mean[2];
    EXPECT_NEAR(mean[0] / sum, line.x, 1e-5) << line.nm;
    EXPECT_NEAR(mean[1] / sum, line.y, 1e-5) << line.nm;
  }
}

TEST(ColorMatching, TakesWavelengthsInEitherOrder) {
  EXPECT_EQ(mean_color_matching(500, 600), mean_color_matching(600, 500));
  EXPECT_EQ(mean_color_matching(900, 1000), (std::array<double, 3>{0, 0, 0}));
}

TEST(BandColor, TakesRedGreenAndBlueForThePrimaries) {
  const BandColor color(Bands{{"red", "green", "blue"}, {700, 600, 500, 400}});
  EXPECT_EQ(color.of(std::vector<double>{1, 2, 3}), (LinearColor{1, 2, 3}));
}

TEST(BandColor, HasTheLuminanceOfTheSpectrum) {
  const Bands bands{{"a", "b", "c", "d"}, {400, 480, 560, 640, 720}};
  const BandColor color(bands);
  const std::vector<double> radiance = {1, 2, 3, 4};
  double expected = 0;
  for (std::size_t b = 0; b < 4; ++b)
    expected += radiance[b] * mean_color_matching(bands.edges[b], bands.edges[b + 1])[1];
  EXPECT_NEAR(luminance(color.of(radiance)), expected, 1e-8);
}

TEST(BandColor, ShowsDaylightWhite) {
  // D65 by Planck's law is near enough to see that no primary is out of place.
  Bands bands{{}, {380}};
  std::vector<double> radiance;
  for (double nm = 385; nm < 780; nm += 10) {
    bands.names.push_back("b" + std::to_string(nm));
    bands.edges.push_back(nm + 5);
    radiance.push_back(planck(nm, 6504));
  }
  const LinearColor color = BandColor(bands).of(radiance);
  for (const double value : color) EXPECT_NEAR(value / luminance(color), 1, 0.1);
}

TEST(BandColor, IsGreyWithoutEdges) {
  EXPECT_EQ(BandColor(Bands{{"a", "b"}, {}}).of(std::vector<double>{1, 3}), (LinearColor{2, 2, 2}));
}

}  // namespace
}  // namespace etendue::band_color_test
