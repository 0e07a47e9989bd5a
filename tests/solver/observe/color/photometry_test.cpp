// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/color/photometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "solver/observe/color/photometric_units.h"
#include "tests/support/checkout.h"

namespace etendue::photometry_test {
namespace {

/// Bands of 1 nm, their middles at whole numbers.
Bands fine_bands(int first, int last) {
  Bands bands{{}, {}};
  for (int nm = first; nm <= last; ++nm) {
    bands.names.push_back(std::to_string(nm));
    bands.edges.push_back(nm - 0.5);
  }
  bands.edges.push_back(last + 0.5);
  return bands;
}

/// Planck's law, radiant exitance of a nanometre [W/(m^2 nm)].
double planckian(double nm, double kelvin) {
  const double wavelength = nm * 1e-9, second_constant = 1.438776877e-2;
  const double first_constant = 2 * M_PI * planck * speed_of_light * speed_of_light;
  return 1e-9 * first_constant / std::pow(wavelength, 5) /
         std::expm1(second_constant / (wavelength * kelvin));
}

/// Lumens of a spectrum and its power from 380 to 780 nm.
struct Seen {
  double lumens = 0;
  double watts = 0;
};

template <class Spectrum>
Seen seen(const Spectrum& spectrum, int first, int last) {
  const Bands bands = fine_bands(first, last);
  const Photometry photometry(bands);
  std::vector<double> radiant;
  Seen result;
  for (int nm = first; nm <= last; ++nm) {
    radiant.push_back(spectrum(nm));
    if (nm >= 380 && nm <= 780) result.watts += radiant.back();
  }
  result.lumens = photometry.luminous(radiant);
  return result;
}

// Every row of the reference: black bodies, white, and single wavelengths.
TEST(Photometry, HasTheEfficaciesOfTheReference) {
  std::ifstream stream(test::checkout("validation/reference/luminous_efficacy.csv"));
  int rows = 0;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with('#') || line.starts_with("source")) continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::string name, total, visible;
    double parameter = 0;
    std::istringstream fields(line);
    if (line.starts_with("equal")) {
      fields >> name >> total >> total >> visible;
      const Seen white = seen([](double) { return 1.; }, 360, 830);
      EXPECT_NEAR(white.lumens / white.watts, std::stod(visible), 1e-4 * std::stod(visible));
    } else {
      fields >> name >> parameter >> total >> visible;
      if (name == "blackbody_K") {
        const Seen body = seen([&](double nm) { return planckian(nm, parameter); }, 360, 830);
        const double whole = 5.670374419e-8 * std::pow(parameter, 4);
        EXPECT_NEAR(body.lumens / whole, std::stod(total), 1e-4 * std::stod(total) + 5e-5) << parameter;
        EXPECT_NEAR(body.lumens / body.watts, std::stod(visible), 1e-4 * std::stod(visible)) << parameter;
      } else {
        EXPECT_EQ(name, "monochromatic_nm");
        const Bands line_band{{"line"}, {parameter - 0.01, parameter + 0.01}};
        EXPECT_NEAR(Photometry(line_band).efficacy()[0], std::stod(total), 1e-4 * std::stod(total))
            << parameter;
      }
    }
    ++rows;
  }
  EXPECT_EQ(rows, 15);
}

TEST(Photometry, TakesEdgesThatFall) {
  const Photometry rising({{"green"}, {500, 600}}), falling({{"green"}, {600, 500}});
  ASSERT_EQ(rising.efficacy().size(), 1U);
  EXPECT_EQ(rising.efficacy()[0], falling.efficacy()[0]);
  EXPECT_EQ(Photometry({{"dark"}, {300, 350}}).efficacy()[0], 0);
  // The table's sum over 1 nm is 106.8569.
  EXPECT_NEAR(830 * Photometry({{"all"}, {0, 830}}).efficacy()[0], 683 * 106.856917, 0.15);
}

TEST(Photometry, OfRedGreenBlueIsTheLuminanceOfTheirColour) {
  const Photometry rgb({{"red", "green", "blue"}, {}});
  EXPECT_NEAR(rgb.efficacy()[1], 683 * 0.7151686788, 1e-6);
  EXPECT_NEAR(rgb.luminous(std::vector<double>{1, 1, 1}), 683, 1e-9);
  EXPECT_FALSE(Photometry(Bands{}).known());
}

// hc/lambda: at 555 nm 3.579e-19 J, 2.234 eV.
TEST(Photometry, CountsPhotons) {
  EXPECT_NEAR(photon_energy(555) / 1.602176634e-19, 1239.841984 / 555, 1e-8);
  const Photometry photometry({{"green"}, {500, 600}});
  EXPECT_NEAR(photometry.photons_per_joule()[0] * photon_energy(550), 1, 1e-15);
}

TEST(Photometry, KnowsWhatLabelsMean) {
  EXPECT_EQ(si_scale("cm", "mW")->length, 0.01);
  EXPECT_EQ(si_scale("cm", "mW")->power, 0.001);
  EXPECT_FALSE(si_scale("inch", "W"));
  EXPECT_FALSE(si_scale("m", "1/s"));
}

// The older units against published conversions (NIST SP 811, appendix B.8).
TEST(PhotometricUnits, AreThoseOfThePublishedTable) {
  const auto in_si = [](const std::string& name) { return find_photometric_unit(name)->in_si; };
  EXPECT_NEAR(in_si("footcandle"), 1.076391e1, 5e-6);
  EXPECT_NEAR(in_si("phot"), 1e4, 1e-9);
  EXPECT_NEAR(in_si("footlambert"), 3.426259, 5e-7);
  EXPECT_NEAR(in_si("lambert"), 3.183099e3, 5e-4);
  EXPECT_NEAR(in_si("stilb"), 1e4, 1e-9);
  EXPECT_NEAR(in_si("apostilb"), 0.3183099, 5e-8);
  EXPECT_EQ(in_si("blondel"), in_si("asb"));
  EXPECT_EQ(in_si("nit"), 1);
  EXPECT_EQ(in_si("lux"), 1);
  EXPECT_EQ(in_si("lm/m^2"), 1);
  EXPECT_EQ(in_si("radphot"), in_si("phot"));
  EXPECT_EQ(in_si("lm/ft^2"), in_si("footcandle"));
  EXPECT_EQ(in_si("lumen"), 1);
  EXPECT_EQ(in_si("candela"), 1);
  EXPECT_EQ(in_si("talbot"), 1);
  EXPECT_EQ(find_photometric_unit("candle"), nullptr);
  EXPECT_EQ(photometric_unit_names(PhotometricDimension::illuminance),
            (std::vector<std::string>{"lx", "lux", "ph", "phot", "fc", "footcandle"}));
}

}  // namespace
}  // namespace etendue::photometry_test
