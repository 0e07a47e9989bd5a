// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/command/sensors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

#include "tests/app/command/small_case.h"

namespace etendue {
namespace {

using std::numbers::pi;
using test::CaseFolder;
using test::etendue_says;
using test::Outcome;
using test::small_case;
using test::text_of;

/// A dark box of clear air under a sky of radiance 1 in two bands, with sensors.
std::string sky_case(const std::string& sensors) {
  return R"([mesh]
edge_length = 1
[[mesh.box]]
region = "air"
min = [0, 0, 0]
max = [1, 1, 1]
[bands]
names = ["blue-green", "yellow"]
edges = [450, 550, 600]
[media.air]
[walls.zmax]
radiance = [1, 2]
uncollided = true
[walls."*"]
[directions]
set = "product"
order = 2
[output]
directory = "results"
)" + sensors;
}

const std::string desk = "[[sensor]]\nname = \"desk\"\nposition = [0.5, 0.5, 0]\nnormal = [0, 0, 1]\n";

/// The numbers of a row: uncollided, collided, value.
std::map<std::string, std::vector<double>> rows_of(const std::string& table) {
  std::map<std::string, std::vector<double>> rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> fields;
    std::istringstream parts(line);
    for (std::string field; std::getline(parts, field, ',');) fields.push_back(field);
    if (fields[0] == "sensor") continue;
    for (std::size_t i = 3; i < 6; ++i)
      rows[fields[0] + " " + fields[1] + " " + fields[2] + " " + fields[6]].push_back(std::stod(fields[i]));
  }
  return rows;
}

// Factor from the middle of a unit square to the one above it: 0.239456470461.
TEST(Sensors, WriteWhatTheyMeasure) {
  const CaseFolder folder(sky_case(desk));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  const std::string table = text_of(folder.path() / "results" / "sensors.csv");
  EXPECT_EQ(table.substr(0, table.find('\n')), "sensor,band,quantity,uncollided,collided,value,unit,error");
  auto rows = rows_of(table);
  const double factor = 0.239456470461 * pi;
  EXPECT_NEAR(rows["desk blue-green irradiance W/m^2"].at(0), factor, 1e-9);
  EXPECT_NEAR(rows["desk yellow irradiance W/m^2"].at(2), 2 * factor, 1e-9);
  EXPECT_EQ(rows["desk yellow irradiance W/m^2"].at(1), 0);
  EXPECT_NE(run.out.find("sensor desk: irradiance yellow 1.5045"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("photopic: V(lambda), 683 lm/W"), std::string::npos) << run.out;
  const double lux = rows["desk photopic illuminance lx"].at(2);
  EXPECT_GT(lux, 300);
  const Outcome feet = etendue_says({"run", folder.file(), "--set", "units.illuminance=\"footcandle\""});
  ASSERT_EQ(feet.code, ExitCode::done) << feet.err;
  rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  EXPECT_NEAR(rows["desk photopic illuminance footcandle"].at(2) * 10.763910416709722 / lux, 1, 1e-12);
}

TEST(Sensors, GridsAndIntensitiesHaveTheirFiles) {
  const CaseFolder folder(sky_case(
      "[[sensor]]\nname = \"floor\"\nkind = \"grid\"\nposition = [0, 0, 0]\nalong = [1, 0, 0]\nacross = [0, "
      "1, 0]\nparts = [3, 2]\n[[sensor]]\nname = \"out\"\nkind = \"intensity\"\nwall = \"zmin\"\nparts = [4, "
      "4]\n[[sensor]]\nname = \"air\"\nkind = \"fluence\"\nposition = [0.5, 0.5, 0.5]\n"));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  const std::filesystem::path results = folder.path() / "results";
  const std::string grid = text_of(results / "floor.grid.csv");
  EXPECT_EQ(std::count(grid.begin(), grid.end(), '\n'), 1 + 3 * 2 * 2);
  EXPECT_FALSE(text_of(results / "floor.grid.exr").empty());
  const std::string intensity = text_of(results / "out.intensity.csv");
  EXPECT_EQ(std::count(intensity.begin(), intensity.end(), '\n'), 1 + 4 * 4 * 2);
  // Straight down goes what the sky sends straight down: L A.
  const std::string down = "\n0,0,blue-green,";
  ASSERT_NE(intensity.find(down), std::string::npos) << intensity;
  EXPECT_NEAR(std::stod(intensity.substr(intensity.find(down) + down.size())), 1, 1e-12);
  EXPECT_NE(text_of(results / "out.ies")
                .find("TILT=NONE\n1 -1 1 4 5 1 2 0 0 0\n1 1 0\n0\n30\n60\n90\n0\n90\n180\n"),
            std::string::npos);
  EXPECT_NE(text_of(results / "out.intensity.svg").find("</svg>"), std::string::npos);
  // u/c: the middle of a cube sees a sixth of the sphere.
  auto rows = rows_of(text_of(results / "sensors.csv"));
  EXPECT_NEAR(rows["air blue-green fluence W/m^2"].at(2), 4 * pi / 6, 1e-9);
  EXPECT_NEAR(rows["air blue-green energy_density J/m^3"].at(2) * 299792458 / (4 * pi / 6), 1, 1e-9);
  EXPECT_NEAR(rows["air blue-green photon_density 1/m^3"].at(2) /
                  (rows["air blue-green energy_density J/m^3"].at(2) / (6.62607015e-34 * 299792458 / 500e-9)),
              1, 1e-9);
}

/// The small case with the account of its region.
std::string account_case(const std::string& more) {
  return test::small_case() +
         "[solve]\ntolerance = 1e-10\n[[sensor]]\nname = \"all\"\nkind = \"region\"\nregion = "
         "\"smoke\"\n" +
         more;
}

// Band by band over wavelengths: per nanometre, and as photons of hc/lambda.
TEST(Sensors, HaveSpectra) {
  const CaseFolder folder(sky_case("[[sensor]]\nname = \"out\"\nkind = \"flux\"\nwall = \"zmin\"\n" + desk));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  const std::string table = text_of(folder.path() / "results" / "out.spectrum.csv");
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(
      line,
      "quantity,band,from_nm,to_nm,photon_energy_J,uncollided,collided,value,unit,per_nm,photons_per_s");
  std::map<std::string, std::vector<double>> rows;
  while (std::getline(lines, line)) {
    std::istringstream parts(line);
    std::vector<std::string> fields;
    for (std::string field; std::getline(parts, field, ',');) fields.push_back(field);
    for (const std::size_t i : {2, 3, 4, 7, 9, 10})
      rows[fields[0] + " " + fields[1]].push_back(std::stod(fields[i]));
  }
  const std::vector<double> yellow = rows.at("flux_forward yellow");
  EXPECT_EQ(yellow[0], 550);
  EXPECT_EQ(yellow[1], 600);
  EXPECT_NEAR(yellow[2] / (6.62607015e-34 * 299792458 / 575e-9), 1, 1e-9);
  // The factor between opposite sides of a cube is 0.1998.
  EXPECT_NEAR(yellow[3] / (2 * pi * 0.19982490), 1, 2e-3);
  EXPECT_NEAR(yellow[4] * 50 / yellow[3], 1, 1e-12);
  EXPECT_NEAR(yellow[5] * yellow[2] / yellow[3], 1, 1e-12);
  EXPECT_EQ(rows.at("flux_backward yellow")[3], 0);
  EXPECT_NE(text_of(folder.path() / "results" / "desk.spectrum.csv").find("irradiance,blue-green,450,550,"),
            std::string::npos);
}

// What walls take from a region is what it emits less what it absorbs; the account closes, and N is its
// energy.
TEST(Sensors, AccountsOfRegionsClose) {
  const CaseFolder folder(
      account_case("[[sensor]]\nname = \"up\"\nkind = \"region\"\nregion = \"smoke\"\ndirection = "
                   "[0, 0, -1]\nangle = 90\n"));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  for (const std::string band : {"red", "green", "blue"}) {
    const auto value = [&](const std::string& quantity, const std::string& unit,
                           const std::string& sensor = "all") {
      return rows[sensor + " " + band + " " + quantity + " " + unit].at(2);
    };
    EXPECT_NEAR(value("account_residual", "1"), 0, 1e-8);
    EXPECT_NEAR(value("account_residual", "1", "up"), 0, 1e-8);
    EXPECT_NEAR((value("flowing_in", "W") - value("flowing_out", "W")) / value("absorbed", "W"), 1, 1e-8);
    EXPECT_NEAR(value("solid_angle", "sr", "up"), 2 * pi, 1e-12);
    EXPECT_LT(value("radiance_integral", "W m", "up"), value("radiance_integral", "W m"));
    EXPECT_NEAR(value("energy", "J") * 299792458 / value("radiance_integral", "W m"), 1, 1e-12);
  }
  EXPECT_EQ(text_of(folder.path() / "results" / "fields.vtu").find("radiance_0"), std::string::npos);
}

// Beside lights, and in a mean over rotated sets, both parts close: the one as the iteration does, the other
// as sums over beams.
TEST(Sensors, AccountsOfRegionsHaveTheLightOfLights) {
  const CaseFolder folder(
      account_case("[[light]]\nname = \"bulb\"\nkind = \"point\"\nposition = [0.5, 0.5, 0.5]\npower = 1\n"));
  const Outcome run = etendue_says({"run", folder.file(), "--set", "directions.rotations=2"});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  const auto row = [&](const std::string& quantity) { return rows["all red " + quantity]; };
  EXPECT_NEAR(row("emitted W").at(0), 1, 1e-9);
  EXPECT_GT(row("radiance_integral W m").at(0), 0);
  EXPECT_GT(row("radiance_integral W m").at(1), 0);
  EXPECT_NEAR(row("account_residual 1").at(1), 0, 1e-8);
  EXPECT_NEAR(row("account_residual 1").at(2), 0, 0.03);
}

TEST(Sensors, AccountsOfRegionsNeedTheSweepThatFirstCollisionsAreIn) {
  const CaseFolder folder(
      account_case("[[light]]\nname = \"bulb\"\nkind = \"point\"\nposition = [0.5, 0.5, 0.5]\npower = 1\n"));
  const Outcome run =
      etendue_says({"run", folder.file(), "--set", "directions.first_collided={set=\"ldfe-sq\",order=2}"});
  EXPECT_EQ(run.code, ExitCode::input_error);
  EXPECT_NE(run.err.find("the account of a region in a run with directions.first_collided"),
            std::string::npos)
      << run.err;
}

TEST(Sensors, OutsideOfTheMeshAreRefused) {
  const CaseFolder folder(
      sky_case("[[sensor]]\nname = \"far\"\nkind = \"fluence\"\nposition = [2, 0, 0]\n[[sensor]]\n"
               "name = \"out\"\nkind = \"intensity\"\nwall = \"roof\"\n"));
  const Outcome run = etendue_says({"run", folder.file()});
  EXPECT_EQ(run.code, ExitCode::input_error);
  EXPECT_NE(run.err.find(
                "the sensor \"far\" lies outside the mesh (which reaches from [0, 0, 0] to [1, 1, 1]); move "
                "it into a region"),
            std::string::npos)
      << run.err;
  EXPECT_NE(run.err.find("= roof: the sensor \"out\" names a wall that the mesh does not have; use "),
            std::string::npos)
      << run.err;
}

}  // namespace
}  // namespace etendue
