// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/read_gas_pressure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/case/build/build.h"
#include "app/case/values/band_values.h"
#include "app/case/values/gray_gases.h"
#include "app/case/values/medium_coefficients.h"
#include "app/case/values/value_algebra.h"
#include "base/blackbody.h"
#include "tests/app/case/case_text.h"

namespace etendue::read_gas_pressure_test {
namespace {

const std::string bordbar = "[bands]\nwsgg = \"bordbar\"\nmolar_ratio = 2\n";

std::string gas(const std::string& bands, const std::string& keys) {
  return cube + bands + "[media.air]\n" + keys;
}

std::string first_fault(const std::string& text) {
  try {
    const Case input = case_of(text);
    build_problem(input, build_mesh(input));
  } catch (const InputError& error) {
    return error.faults().front().text;
  }
  return "";
}

double blackbody(double kelvin) { return stefan_boltzmann / std::numbers::pi * std::pow(kelvin, 4); }

TEST(ReadGasPressure, MakesEachGasABand) {
  const Case input = case_of(gas(bordbar, "gas_pressure = 0.3\nabsorption = 0.02\ntemperature = 1400\n"));
  EXPECT_EQ(input.bands.names, (std::vector<std::string>{"clear", "gray-1", "gray-2", "gray-3", "gray-4"}));
  const TetrahedralMesh mesh = build_mesh(input);
  const Problem problem = build_problem(input, mesh);
  const GrayGases wsgg = bordbar_gases(2);
  for (int band = 0; band < 5; ++band) {
    const GrayGas& gray = wsgg.gases[static_cast<std::size_t>(band)];
    const double absorption = 0.02 + 0.3 * gray.absorption.at(1400);
    EXPECT_NEAR(problem.absorption(CellIndex(0), band), absorption, 1e-12 * absorption);
    const double emission = absorption * gray.weight.at(1400) * blackbody(1400);
    EXPECT_NEAR(problem.emission(CellIndex(0), band), emission, 1e-12 * emission);
  }
}

// Formulas give the same as numbers: pressures and temperatures of the place, also below the lowest of the
// fit.
TEST(ReadGasPressure, TakesFormulas) {
  for (const std::string kelvin : {"1400", "250"}) {
    const Case numbers = case_of(gas(bordbar, "gas_pressure = 0.3\ntemperature = " + kelvin + "\n"));
    const Case formulas =
        case_of(gas(bordbar, "gas_pressure = \"0.3 + 0*x\"\ntemperature = \"" + kelvin + " + 0*x\"\n"));
    const TetrahedralMesh mesh = build_mesh(numbers);
    const Problem a = build_problem(numbers, mesh), b = build_problem(formulas, mesh);
    for (int band = 0; band < 5; ++band) {
      EXPECT_NEAR(b.absorption(CellIndex(0), band), a.absorption(CellIndex(0), band), 1e-12) << band;
      EXPECT_NEAR(b.emission(CellIndex(0), band), a.emission(CellIndex(0), band), 1e-12 * blackbody(1400))
          << band;
    }
  }
}

// A ratio by a formula is as one by a number, in media and walls.
TEST(ReadGasPressure, TakesAMixtureOfThePlace) {
  const auto with_ratio = [](const std::string& ratio) {
    return gas("[bands]\nwsgg = \"bordbar\"\nmolar_ratio = " + ratio +
                   "\n[walls.zmin]\nemissivity = 0.8\ntemperature = 1000\n",
               "gas_pressure = 0.3\nabsorption = 0.02\ntemperature = 1400\n");
  };
  const Case whole = case_of(with_ratio("0.7"));
  EXPECT_FALSE(whole.molar_ratio);
  const TetrahedralMesh mesh = build_mesh(whole);
  const Problem expected = build_problem(whole, mesh);
  for (const std::string ratio : {"\"0.7 + 0*x\"", "\"z < 2 ? 0.7 : 1\""}) {
    const Case input = case_of(with_ratio(ratio));
    const Problem own = build_problem(input, mesh);
    for (int band = 0; band < 5; ++band) {
      const double absorption = expected.absorption(CellIndex(0), band);
      EXPECT_NEAR(own.absorption(CellIndex(0), band), absorption, 1e-12 * absorption) << ratio;
      const double emission = expected.emission(CellIndex(0), band);
      EXPECT_NEAR(own.emission(CellIndex(0), band), emission, 1e-11 * emission) << ratio;
      const double radiance = std::get<double>(value_of(whole.walls.at("zmin").radiance, band));
      const Value& by_place = value_of(input.walls.at("zmin").radiance, band);
      EXPECT_NEAR(coefficient_of(by_place).at(Vec3(0.5, 0.5, 0)), radiance, 1e-11 * radiance) << ratio;
    }
  }
}

TEST(ReadGasPressure, TakesAnotherMixtureAtEachPlace) {
  const std::string keys = "gas_pressure = 0.3\ntemperature = 1400\n";
  const Case input = case_of(gas("[bands]\nwsgg = \"bordbar\"\nmolar_ratio = \"x < 0.5 ? -3 : 9\"\n", keys));
  const Coefficient absorption = coefficient_of(matter_values(input.media.at("air"), 2).absorption);
  for (const auto& [x, ratio] : {std::pair(0.2, 0.01), std::pair(0.8, 4.0)})
    EXPECT_NEAR(absorption.at(Vec3(x, 0, 0)), 0.3 * bordbar_gases(ratio).gases[2].absorption.at(0), 1e-12);
}

TEST(ReadGasPressure, RefusesMixturesThatAreNotKnown) {
  const auto by_ratio = [](const std::string& ratio) {
    return "[bands]\nwsgg = \"bordbar\"\nmolar_ratio = " + ratio + "\n";
  };
  EXPECT_EQ(first_fault(gas(by_ratio("\"0/(x-x)\""), "gas_pressure = 0.3\ntemperature = 1000\n"))
                .find("bands.molar_ratio: no number at ("),
            0u);
  EXPECT_NE(first_fault(gas(by_ratio("\"1+x\""), "gas_pressure = 0.3\nheat_source = 1e4\n"))
                .find("a formula or field, but the temperature of media.air follows by iteration"),
            std::string::npos);
  EXPECT_NE(first_fault(gas(by_ratio("[1, 2]"), "gas_pressure = 0.3\n")), "");
}

TEST(ReadGasPressure, LetsWallsEmitTheWeightsOfTheirTemperature) {
  const Case input = case_of(cube +
                             "[bands]\nwsgg = \"smith-1\"\n[walls.zmin]\nemissivity = 0.8\n"
                             "temperature = 1000\n");
  const Problem problem = build_problem(input, build_mesh(input));
  const GrayGases wsgg = smith_gases(1);
  double sum = 0;
  for (const Wall& wall : problem.walls())
    if (wall.name == "zmin")
      for (std::size_t band = 0; band < 4; ++band) {
        EXPECT_NEAR(wall.radiance[band], 0.8 * wsgg.gases[band].weight.at(1000) * blackbody(1000), 1e-8);
        sum += wall.radiance[band];
      }
  EXPECT_NEAR(sum, 0.8 * blackbody(1000), 1e-8);
}

TEST(ReadGasPressure, RefusesWhatHasNoMeaning) {
  EXPECT_EQ(first_fault(gas("", "gas_pressure = 0.3\n")),
            "media.air.gas_pressure = 0.3: needs gray gases; add bands.wsgg or bands.k_distribution, or "
            "give absorption instead");
  EXPECT_EQ(first_fault(gas(bordbar, "gas_pressure = 0.3\nextinction = 1\n")),
            "media.air.gas_pressure = 0.3: not beside extinction (gases add to absorption); give absorption "
            "and scattering");
  EXPECT_NE(first_fault(gas(bordbar + "names = [\"a\"]\n", "gas_pressure = 0.3\n"))
                .find("not beside wsgg, whose gray gases are the bands"),
            std::string::npos);
  EXPECT_NE(first_fault(gas("[bands]\nwsgg = \"bordbar\"\n", "gas_pressure = 0.3\n"))
                .find("give that of water vapour to carbon dioxide"),
            std::string::npos);
  EXPECT_NE(
      first_fault(gas("[bands]\nwsgg = \"bordbar\"\nmolar_ratio = 5\n", "")).find("each from 0.01 to 4"),
      std::string::npos);
  EXPECT_NE(first_fault(gas(bordbar, "gas_pressure = 0.3\ntemperature = 2500\n"))
                .find("the gray gases of the bands are known up to 2400 K"),
            std::string::npos);
}

}  // namespace
}  // namespace etendue::read_gas_pressure_test
