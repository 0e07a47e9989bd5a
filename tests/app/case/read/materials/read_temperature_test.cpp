// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/read_temperature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/blackbody.h"
#include "base/expression/expression.h"
#include "tests/app/case/case_text.h"

namespace etendue::read_temperature_test {
namespace {

constexpr double pi = std::numbers::pi;

const std::string two_bands = "[bands]\nnames = [\"short\", \"long\"]\nedges = [1, 3000, 1e9]\n";

std::string air(const std::string& keys) { return cube + "[media.air]\n" + keys; }
std::string floor_wall(const std::string& keys) { return cube + "[walls.zmin]\n" + keys; }

double number(const BandValues& values, std::size_t band = 0) {
  return std::get<double>(values.values.at(band));
}

double at(const Value& formula, double x) {
  return Expression(std::get<Formula>(formula), {"x", "y", "z"})(std::array{x, 0.0, 0.0});
}

// One band without edges: kappa sigma T^4/pi.
TEST(ReadTemperature, MakesAMediumEmitAsABlackbody) {
  const Case input = case_of(air("absorption = 0.5\ntemperature = 1000\n"));
  EXPECT_NEAR(number(*input.media.at("air").emission), 0.5 * 5.670374419e4 / pi, 1e-9);
}

TEST(ReadTemperature, DividesThePowerAmongTheBands) {
  const Case input = case_of(air("absorption = [0.5, 2]\ntemperature = 1500\n") + two_bands);
  const BandValues& emission = *input.media.at("air").emission;
  ASSERT_EQ(emission.values.size(), 2u);
  const double total = stefan_boltzmann * std::pow(1500, 4) / pi;
  const double share = planck_fraction(3000, 1500) - planck_fraction(1, 1500);
  EXPECT_NEAR(number(emission, 0), 0.5 * total * share, 1e-12 * total);
  EXPECT_NEAR(number(emission, 1), 2 * total * (planck_fraction(1e9, 1500) - planck_fraction(3000, 1500)),
              1e-12 * total);
  // All wavelengths together are the grey blackbody.
  EXPECT_NEAR(number(emission, 0) / 0.5 + number(emission, 1) / 2, total, 1e-9 * total);
}

TEST(ReadTemperature, TakesFormulas) {
  const Case input = case_of(air("absorption = \"1 + x\"\ntemperature = \"300 + 200*x\"\n") + two_bands);
  const BandValues& emission = *input.media.at("air").emission;
  ASSERT_EQ(emission.values.size(), 2u);
  const double expected =
      1.5 * stefan_boltzmann * std::pow(400, 4) / pi * (planck_fraction(3000, 400) - planck_fraction(1, 400));
  EXPECT_NEAR(at(emission.values[0], 0.5), expected, 1e-12 * expected);
}

TEST(ReadTemperature, MakesAWallEmitWhatItDoesNotReflect) {
  const WallCase grey = case_of(floor_wall("emissivity = 0.8\ntemperature = 500\n")).walls.at("zmin");
  EXPECT_NEAR(number(grey.diffuse), 0.2, 1e-15);
  EXPECT_NEAR(number(grey.radiance), 0.8 * stefan_boltzmann * std::pow(500, 4) / pi, 1e-12);
  const WallCase shiny =
      case_of(floor_wall("diffuse = 0.1\nspecular = 0.3\ntemperature = 500\n")).walls.at("zmin");
  EXPECT_NEAR(number(shiny.radiance), 0.6 * stefan_boltzmann * std::pow(500, 4) / pi, 1e-12);
  const WallCase cold = case_of(floor_wall("emissivity = 0.7\nspecular = 0.1\n")).walls.at("zmin");
  EXPECT_NEAR(number(cold.diffuse), 0.2, 1e-15);
  EXPECT_EQ(number(cold.radiance), 0);
}

TEST(ReadTemperature, IsReadAgainFromTheResolvedCase) {
  const std::string resolved =
      case_of(floor_wall("emissivity = 0.8\ntemperature = \"300 + x\"\n[media.air]\ntemperature = 900\n"))
          .resolved_toml;
  EXPECT_EQ(faults_of(resolved), "") << resolved;
  EXPECT_NEAR(number(case_of(resolved).walls.at("zmin").diffuse), 0.2, 1e-15);
}

TEST(ReadTemperature, RefusesWhatCannotBeARadiance) {
  EXPECT_EQ(
      faults_of(air("temperature = 900\n[bands]\nnames = [\"a\", \"b\"]\n")),
      "slab.toml:8: media.air.temperature = 900: needs the edges of the 2 bands, which divide the power of a "
      "blackbody; add bands.edges [nm], or use one band");
  EXPECT_EQ(faults_of(air("temperature = 900\n[units]\nlength = \"mm\"\n")),
            "slab.toml:8: media.air.temperature = 900: needs meters and watts (the case has mm and W); write "
            "coordinates in meters (mesh.scale multiplies those of files) with units.length = \"m\", and "
            "units.power = "
            "\"W\"");
  EXPECT_EQ(faults_of(air("temperature = 900\npower = 3\n")),
            "slab.toml:8: media.air.temperature = 900: power is given too, and both say what is emitted; use "
            "one of "
            "them");
  EXPECT_EQ(
      faults_of(air("temperature = -3\n")),
      "slab.toml:8: media.air.temperature = -3: out of range; use a number, a formula in x, y, z or { file, "
      "array }, each at least 0");
  EXPECT_EQ(
      faults_of(air("absorption = \"1 + wx^2\"\ntemperature = 900\n")),
      "slab.toml:9: media.air.temperature = 900: not where absorption depends on the direction (not in this "
      "version); use emission");
}

TEST(ReadTemperature, LeavesFaultyBandsToTheirOwnFault) {
  const std::string faults =
      faults_of(air("temperature = 900\n[bands]\nnames = [\"a\", \"b\"]\nedges = [1, 2]\n"));
  EXPECT_EQ(std::ranges::count(faults, '\n'), 0) << faults;
  EXPECT_NE(faults.find("edges"), std::string::npos) << faults;
}

// What is behind a smooth wall has the index of vacuum, and sends no n^2 times as much itself.
TEST(ReadTemperature, MayBeThatOfWhatIsBehindASmoothWall) {
  const Case input =
      case_of(cube +
              "[media.air]\nrefractive_index = 1.5\n[walls.zmin]\nrefractive_index = 1.5\ntemperature = 500\n"
              "[walls.zmax]\nemissivity = 0.5\ntemperature = 500\n");
  EXPECT_EQ(input.bands.refractive_index, 1.5);
  const double radiance = stefan_boltzmann * std::pow(500.0, 4) / pi;
  EXPECT_NEAR(std::get<double>(input.walls.at("zmin").radiance.values.at(0)) / radiance, 1, 1e-12);
  EXPECT_NEAR(std::get<double>(input.walls.at("zmax").radiance.values.at(0)) / radiance, 0.5 * 2.25, 1e-12);
}

TEST(ReadTemperature, RefusesRefractionByAnotherIndexThanThatOfTheMedia) {
  EXPECT_NE(faults_of(floor_wall("refractive_index = 1.5\n[media.air]\ntemperature = 500\n"))
                .find("whose media have 1; give them the same"),
            std::string::npos);
}

TEST(ReadTemperature, RefusesAWallThatBreaksKirchhoffsLaw) {
  EXPECT_EQ(
      faults_of(floor_wall("diffuse = 0.3\nemissivity = 0.8\n")),
      "slab.toml:9: walls.zmin.emissivity = 0.8: differs from 1 - diffuse - specular - transmittance = 0.7 "
      "(Kirchhoff's law); leave diffuse or emissivity out");
  EXPECT_EQ(faults_of(floor_wall("specular = 0.3\nemissivity = 0.8\n")),
            "slab.toml:9: walls.zmin.emissivity = 0.8: emissivity + specular + transmittance = 1.1; use at "
            "most 1");
  EXPECT_EQ(faults_of(floor_wall("radiance = 3\ntemperature = 800\n")),
            "slab.toml:9: walls.zmin.temperature = 800: radiance is given too, and both say what is emitted; "
            "use one "
            "of them");
}

}  // namespace
}  // namespace etendue::read_temperature_test
