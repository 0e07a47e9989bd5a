// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/readings/sensors.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <tuple>

#include "app/case/lamps/ies_file.h"
#include "app/write/image/toned_png.h"
#include "solver/observe/color/photometry.h"
#include "tests/app/readings/sensor_table.h"
#include "tests/app/run/box_case.h"
#include "tests/app/run/csv_table.h"
#include "tests/app/run/small_case.h"

namespace etendue::sensors_test {
namespace {

using std::numbers::pi;
using test::box_case;
using test::CaseFolder;
using test::CsvTable;
using test::etendue_says;
using test::Outcome;
using test::rows_of;
using test::small_case;
using test::text_of;

const std::string two_bands = "names = [\"blue-green\", \"yellow\"]\nedges = [450, 550, 600]";

/// A dark box of clear air under a sky of radiance 1 in two bands, with sensors.
std::string sky_case(const std::string& sensors) {
  return box_case({.bands = two_bands},
                  "[walls.zmax]\nradiance = [1, 2]\nuncollided = true\n[walls.\"*\"]\n" + sensors);
}

const std::string desk = "[[sensor]]\nname = \"desk\"\nposition = [0.5, 0.5, 0]\nnormal = [0, 0, 1]\n";

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
  EXPECT_NE(run.out.find("sensor desk: irradiance yellow 1.505 W/m^2 (uncollided 1.505)\n"),
            std::string::npos)
      << run.out;
  EXPECT_NE(run.out.find("photopic: V(lambda), 683 lm/W"), std::string::npos) << run.out;
  const double lux = rows["desk photopic illuminance lx"].at(2);
  EXPECT_GT(lux, 300);
  const Outcome feet = etendue_says({"run", folder.file(), "--set", "units.illuminance=\"footcandle\""});
  ASSERT_EQ(feet.code, ExitCode::done) << feet.err;
  rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  EXPECT_NEAR(rows["desk photopic illuminance footcandle"].at(2) * 10.763910416709722 / lux, 1, 1e-12);
}

// A sky of radiance L sends in pi L: lumens per area that leave a surface, which are no lux.
TEST(Sensors, LuminousExitanceIsInLumensPerArea) {
  const CaseFolder folder(
      sky_case("[[sensor]]\nname = \"sky\"\nkind = \"exitance\"\nposition = [0.4, 0.5, 1]\nnormal = [0, 0, "
               "-1]\n"));
  const Photometry seen({{"blue-green", "yellow"}, {450, 550, 600}});
  const double lumens = pi * (seen.efficacy()[0] + 2 * seen.efficacy()[1]);
  for (const auto& [unit, in_si] : {std::pair<std::string, double>{"lm/m^2", 1}, {"lm/cm^2", 1e4}}) {
    const Outcome run =
        etendue_says({"run", folder.file(), "--set", "units.luminous_exitance=\"" + unit + "\""});
    ASSERT_EQ(run.code, ExitCode::done) << run.err;
    auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
    ASSERT_TRUE(rows.contains("sky photopic luminous_exitance " + unit));
    EXPECT_NEAR(rows["sky photopic luminous_exitance " + unit].at(2) * in_si / lumens, 1, 1e-6);
  }
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
  EXPECT_EQ(std::count(intensity.begin(), intensity.end(), '\n'), 1 + 4 * 4 * 3) << "and as the eye sees it";
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

// The numbers of NAME.grid.csv as a camera would have them: each part a square of 512/3 pixels, black outside
// of the mesh.
TEST(Sensors, GridsArePictures) {
  const CaseFolder folder(sky_case(
      "[[sensor]]\nname = \"floor\"\nkind = \"grid\"\nposition = [0.25, 0, 0]\nalong = [1.5, 0, 0]\nacross = "
      "[0, 1, 0]\nparts = [3, 2]\n"));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  std::vector<std::array<double, 2>> parts(6, {0, 0});
  for (const auto& fields : CsvTable(text_of(folder.path() / "results" / "floor.grid.csv")).rows())
    parts[std::stoul(fields[1]) * 3 + std::stoul(fields[0])][fields[5] == "yellow" ? 1 : 0] =
        std::stod(fields[8]);
  EXPECT_GT(parts[1][0], 0);
  EXPECT_EQ(parts[2][0], 0) << "outside";
  const BandColor rule({{"blue-green", "yellow"}, {450, 550, 600}});
  std::vector<LinearColor> colors;
  for (std::size_t y = 0; y < 340; ++y)
    for (std::size_t x = 0; x < 510; ++x) colors.push_back(rule.of(parts[y / 170 * 3 + x / 170]));
  EXPECT_EQ(text_of(folder.path() / "results" / "floor.grid.png"),
            toned_png({510, 340}, balanced(colors, WhiteBalance({{"blue-green", "yellow"}, {450, 550, 600}})),
                      std::nullopt, Tone::linear));
}

/// A furnace of radiance 1 and 2 in a box of volume 1, with sensors.
std::string furnace_case(const std::string& sensors) {
  return box_case(
      {.bands = two_bands, .order = 4},
      "[walls.\"*\"]\nradiance = [1, 2]\nuncollided = false\n[solve]\ntolerance = 1e-12\n" + sensors);
}

/// Photons of a joule at the middle of a band, lambda/(h c) [1/J].
double photons_of_a_joule(double nanometres) { return nanometres * 1e-9 / (6.62607015e-34 * 299792458); }

// Energy u/c, photons of hc/lambda each, W and photons per second, and what the eye sees of it, all closed.
TEST(Sensors, CountPhotonsOfAFurnace) {
  const CaseFolder folder(furnace_case(
      "[[sensor]]\nname = \"all\"\nkind = \"region\"\nregion = \"air\"\n[[sensor]]\nname = \"part\"\nkind = "
      "\"region\"\nregion = \"air\"\ndirection = [0, 0, 1]\nangle = 60\n[[sensor]]\nname = \"out\"\nkind = "
      "\"flux\"\nwall = \"zmin\"\n[[sensor]]\nname = \"air\"\nkind = \"fluence\"\nposition = [0.4, 0.5, "
      "0.6]\n"));
  const Outcome run = etendue_says({"run", folder.file(), "--set", "units.luminous_energy=\"talbot\"",
                                    "--set", "units.luminous_flux=\"lumen\""});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  constexpr double c = 299792458;
  const auto value = [&](const std::string& row) { return rows[row].at(2); };
  for (const auto& [band, u, middle] : {std::tuple("blue-green", 1., 500.), std::tuple("yellow", 2., 575.)}) {
    const std::string b = std::string(" ") + band + " ";
    const double photons = photons_of_a_joule(middle);
    EXPECT_NEAR(value("all" + b + "energy J") * c / (4 * pi * u), 1, 1e-9);
    EXPECT_NEAR(value("all" + b + "photons 1") * c / (4 * pi * u * photons), 1, 1e-9);
    const double cone = value("part" + b + "solid_angle sr");
    EXPECT_NEAR(cone, pi, 1) << "ordinates in the cone";
    EXPECT_NEAR(value("part" + b + "photons 1") * c / (cone * u * photons), 1, 1e-9);
    EXPECT_NEAR(value("air" + b + "energy_density J/m^3") * c / (4 * pi * u), 1, 1e-5);
    EXPECT_NEAR(value("air" + b + "photon_density 1/m^3") * c / (4 * pi * u * photons), 1, 1e-5);
    EXPECT_NEAR(value("out" + b + "flux_forward W") / (pi * u), 1, 1e-5);
    EXPECT_NEAR(
        value("out" + b + "photon_flux_forward 1/s") / (photons * value("out" + b + "flux_forward W")), 1,
        1e-12);
  }
  const double lumens = value("out photopic luminous_flux_forward lumen");
  EXPECT_GT(lumens, 683 * pi);
  EXPECT_NEAR(value("all photopic luminous_energy talbot") * c / (4 * lumens), 1, 1e-5);
}

// What is no power has another unit.
TEST(Sensors, SpectraHaveTheUnitsOfTheirPhotons) {
  const CaseFolder folder(furnace_case(
      "[[sensor]]\nname = \"all\"\nkind = \"region\"\nregion = \"air\"\n[[sensor]]\nname = \"air\"\nkind = "
      "\"fluence\"\nposition = [0.4, 0.5, 0.6]\n[[sensor]]\nname = \"eye\"\nkind = \"radiance\"\nposition = "
      "[0.4, "
      "0.5, 0.6]\ndirection = [1, 0, 0]\n"));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  const auto last_of = [&](const std::string& sensor, const std::string& quantity) {
    std::istringstream lines(text_of(folder.path() / "results" / (sensor + ".spectrum.csv")));
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with(quantity + ",")) return line.substr(line.rfind(',') + 1);
    return std::string("none");
  };
  EXPECT_EQ(last_of("all", "absorbed"), "1/s");
  EXPECT_EQ(last_of("all", "radiance_integral"), "m/s");
  EXPECT_EQ(last_of("air", "fluence"), "1/(s m^2)");
  EXPECT_EQ(last_of("eye", "radiance"), "1/(s m^2 sr)");
}

// I = L A cos, in candela as the eye sees the bands; the IES file says the same when it is read back.
TEST(Sensors, IntensitiesAreInCandelaToo) {
  const CaseFolder folder(
      sky_case("[[sensor]]\nname = \"out\"\nkind = \"intensity\"\nwall = \"zmin\"\nparts = [8, 4]\n"));
  const Outcome run = etendue_says({"run", folder.file(), "--set", "units.luminous_intensity=\"candela\""});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  const Photometry seen({{"blue-green", "yellow"}, {450, 550, 600}});
  const double straight = seen.efficacy()[0] + 2 * seen.efficacy()[1];
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  EXPECT_NEAR(rows["out photopic luminous_intensity_most candela"].at(2) / straight, 1, 1e-9);
  std::vector<double> candela;
  const std::string intensities = text_of(folder.path() / "results" / "out.intensity.csv");
  EXPECT_TRUE(intensities.starts_with("polar,azimuth,band,uncollided,collided,intensity,unit\n"))
      << intensities;
  for (const auto& fields : CsvTable(intensities).rows())
    if (fields[2] == "photopic") {
      EXPECT_EQ(fields[6], "candela");
      candela.push_back(std::stod(fields[5]));
    }
  ASSERT_EQ(candela.size(), 32U);
  EXPECT_NEAR(candela[0] / straight, 1, 1e-9);
  const std::filesystem::path file = folder.path() / "results" / "out.ies";
  std::ifstream stream(file);
  const LightTable table = read_ies(stream, file);
  ASSERT_EQ(table.plane.size(), 9U);
  ASSERT_EQ(table.angle, (std::vector<double>{0, 30, 60, 90}));
  // A plane for each azimuth and the first again.
  for (std::size_t plane = 0; plane < 9; ++plane)
    for (std::size_t angle = 0; angle < 4; ++angle)
      EXPECT_NEAR(table.intensity[plane * 4 + angle], candela[angle * 8 + plane % 8], 1e-5 * straight);
}

// Where the eye sees most is not where each band has most.
TEST(Sensors, GridsHaveTheirMostAndLeastIlluminance) {
  const CaseFolder folder(sky_case(
      "[[sensor]]\nname = \"floor\"\nkind = \"grid\"\nposition = [0, 0, 0]\nalong = [1, 0, 0]\nacross = [0, "
      "1, 0]\nparts = [3, 3]\n"));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  const Photometry seen({{"blue-green", "yellow"}, {450, 550, 600}});
  for (const std::string end : {"least", "most"}) {
    const double blue = rows["floor blue-green irradiance_" + end + " W/m^2"].at(2);
    EXPECT_NEAR(rows["floor photopic illuminance_" + end + " lx"].at(2) /
                    (blue * (seen.efficacy()[0] + 2 * seen.efficacy()[1])),
                1, 1e-9);
  }
}

// Band by band over wavelengths: per nanometre, and as photons of hc/lambda.
TEST(Sensors, HaveSpectra) {
  const CaseFolder folder(sky_case("[[sensor]]\nname = \"out\"\nkind = \"flux\"\nwall = \"zmin\"\n" + desk));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  const std::string table = text_of(folder.path() / "results" / "out.spectrum.csv");
  EXPECT_TRUE(table.starts_with(
      "quantity,band,from_nm,to_nm,photon_energy_J,uncollided,collided,value,unit,per_nm,photons,"
      "photon_unit\n"))
      << table;
  std::map<std::string, std::vector<double>> rows;
  for (const auto& fields : CsvTable(table).rows())
    for (const std::size_t i : {2, 3, 4, 7, 9, 10})
      rows[fields[0] + " " + fields[1]].push_back(std::stod(fields[i]));
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
}  // namespace etendue::sensors_test
