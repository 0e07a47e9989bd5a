// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/command/sensors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <tuple>

#include "app/case/ies_file.h"
#include "solver/sensors/photometry.h"
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

/// A furnace of radiance 1 and 2 in a box of volume 1, with sensors.
std::string furnace_case(const std::string& sensors) {
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
[walls."*"]
radiance = [1, 2]
uncollided = false
[directions]
set = "product"
order = 4
[solve]
tolerance = 1e-12
[output]
directory = "results"
)" + sensors;
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
  std::istringstream lines(text_of(folder.path() / "results" / "out.intensity.csv"));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "polar,azimuth,band,uncollided,collided,intensity,unit");
  while (std::getline(lines, line)) {
    std::vector<std::string> fields;
    std::istringstream parts(line);
    for (std::string field; std::getline(parts, field, ',');) fields.push_back(field);
    if (fields[2] == "photopic") {
      EXPECT_EQ(fields[6], "candela");
      candela.push_back(std::stod(fields[5]));
    }
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
  EXPECT_EQ(line,
            "quantity,band,from_nm,to_nm,photon_energy_J,uncollided,collided,value,unit,per_nm,photons,"
            "photon_unit");
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

// Light that has collided once on a set of its own is in the account too.
TEST(Sensors, AccountsOfRegionsHaveLightThatCollidedOnce) {
  const CaseFolder folder(
      account_case("[[light]]\nname = \"bulb\"\nkind = \"point\"\nposition = [0.5, 0.5, 0.5]\npower = 1\n"));
  const Outcome run =
      etendue_says({"run", folder.file(), "--set", "directions.first_collided={set=\"product\",order=4}"});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  for (const std::string band : {"red", "green", "blue"}) {
    const auto row = [&](const std::string& quantity) { return rows["all " + band + " " + quantity]; };
    EXPECT_NEAR(row("account_residual 1").at(1), 0, 1e-8);
    // What lights scatter comes on top of what is scattered on.
    EXPECT_NEAR((row("scattered_in W").at(1) - row("scattered_out W").at(0)) / row("scattered_out W").at(1),
                1, 1e-8);
  }
}

/// A column of a table whose first two are a name and a band.
double number_in(const std::string& table, const std::string& name, const std::string& band,
                 std::size_t column) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream parts(line);
    std::vector<std::string> fields;
    for (std::string field; std::getline(parts, field, ',');) fields.push_back(field);
    if (fields[0] == name && fields[1] == band) return std::stod(fields.at(column));
  }
  ADD_FAILURE() << name << " " << band << " is not in\n" << table;
  return 0;
}

/// Smoke around a block that shines, and what flows through their surfaces.
std::string block_case(const std::string& directions) {
  return R"([mesh]
max_volume = 0.02
[[mesh.box]]
region = "smoke"
min = [0, 0, 0]
max = [1, 1, 1]
walls = { xmin = "mirror", zmin = "below", zmax = "above" }
[[mesh.box]]
region = "block"
min = [0.3, 0.3, 0]
max = [0.7, 0.7, 1]
walls = { zmin = "below", zmax = "above" }
[media.smoke]
absorption = 0.2
scattering = 1.0
phase = { model = "henyey-greenstein", g = 0.4 }
scattering_method = "moments"
[media.block]
absorption = 2
emission = 1
uncollided = false
[walls.mirror]
specular = 0.9
[walls.below]
specular = 1
[walls.above]
specular = 1
[walls."*"]
diffuse = 0.3
[solve]
tolerance = 1e-11
[[sensor]]
name = "surface"
kind = "flux"
region = "block"
[[sensor]]
name = "sides"
kind = "flux"
region = "block"
beyond = "smoke"
[[sensor]]
name = "back"
kind = "flux"
region = "smoke"
beyond = "block"
[[sensor]]
name = "mirror"
kind = "flux"
region = "smoke"
beyond = "mirror"
[[sensor]]
name = "rising"
kind = "flux"
region = "block"
beyond = "smoke"
direction = [-1, 0, 0]
angle = 60
[[sensor]]
name = "smoke"
kind = "region"
region = "smoke"
[output]
directory = "results"
)" + directions;
}

void expect_surfaces_balance(const std::string& directions) {
  const CaseFolder folder(block_case(directions));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  const std::string regions = text_of(folder.path() / "results" / "regions.csv");
  const std::string walls = text_of(folder.path() / "results" / "walls.csv");
  const auto value = [&](const std::string& sensor, const std::string& quantity) {
    return rows[sensor + " grey " + quantity].at(2);
  };
  const double balance = number_in(regions, "block", "grey", 5) - number_in(regions, "block", "grey", 4);
  EXPECT_GT(balance, 0.01);
  EXPECT_NEAR(value("surface", "flux_net W") / balance, 1, 1e-8);
  EXPECT_NEAR(value("sides", "flux_net W") / balance, 1, 1e-8) << "mirrors take nothing";
  EXPECT_NEAR(value("back", "flux_forward W") / value("sides", "flux_backward W"), 1, 1e-12);
  EXPECT_NEAR(value("mirror", "flux_forward W") / number_in(walls, "mirror", "grey", 4), 1, 1e-8);
  EXPECT_NEAR(value("mirror", "flux_backward W") / number_in(walls, "mirror", "grey", 5), 1, 1e-8);
  EXPECT_GT(value("rising", "flux_forward W"), value("rising", "flux_backward W"));
  EXPECT_LT(value("rising", "flux_forward W"), value("sides", "flux_forward W") / 2);
  EXPECT_NEAR(value("smoke", "account_residual 1"), 0, 1e-8);
}

// What flows out of the closed surface of a region is what it emits less what it absorbs.
TEST(Sensors, FluxThroughTheSurfaceOfARegionIsItsBalance) {
  expect_surfaces_balance("[directions]\nset = \"product\"\norder = 4\n");
}

// The same in the plane, and at points the sums over directions that probes show.
TEST(Sensors, ReadOrdinatesInFlatland) {
  const std::string plane = "[directions]\nset = \"flatland\"\norder = 16\n";
  expect_surfaces_balance(plane);
  const CaseFolder folder(block_case(plane + R"([[sensor]]
name = "wall"
kind = "flux"
wall = "xmax"
[[sensor]]
name = "point"
position = [0.85, 0.4, 0.5]
normal = [-1, 0, 0]
[[sensor]]
name = "around"
kind = "fluence"
position = [0.85, 0.4, 0.5]
[[probe]]
name = "point"
points = [[0.85, 0.4, 0.5]]
normal = [-1, 0, 0]
)"));
  const Outcome run = etendue_says(
      {"run", folder.file(), "--set", "directions.rotations=2", "--set", "walls.mirror.specular=0"});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  const std::string walls = text_of(folder.path() / "results" / "walls.csv");
  EXPECT_NEAR(rows["wall grey flux_forward W"].at(2) / number_in(walls, "xmax", "grey", 4), 1, 1e-8);
  EXPECT_NEAR(rows["wall grey flux_backward W"].at(2) / number_in(walls, "xmax", "grey", 5), 1, 1e-8);
  std::istringstream lines(text_of(folder.path() / "results" / "probes.csv"));
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  std::vector<std::string> fields;
  std::istringstream parts(line);
  for (std::string field; std::getline(parts, field, ',');) fields.push_back(field);
  EXPECT_NEAR(rows["around grey fluence W/m^2"].at(2) / std::stod(fields[6]), 1, 1e-10);
  EXPECT_NEAR(rows["point grey irradiance W/m^2"].at(2) / std::stod(fields[10]), 1, 1e-10);
  EXPECT_EQ(rows["smoke grey radiance_integral W m"].size(), 3U);
  EXPECT_NEAR(rows["smoke grey solid_angle rad"].at(2), 2 * pi, 1e-12);
}

TEST(Sensors, ThatNeedRaysAreRefusedInFlatland) {
  const CaseFolder folder(
      block_case("[directions]\nset = \"flatland\"\norder = 8\n[[sensor]]\nname = \"eye\"\n"
                 "kind = \"radiance\"\nposition = [0.1, 0.1, 0.5]\ndirection = [1, 0, 0]\n"));
  const Outcome run = etendue_says({"run", folder.file()});
  EXPECT_EQ(run.code, ExitCode::input_error);
  EXPECT_NE(run.err.find("a sensor of this kind in flatland (not in this version); use irradiance, fluence, "
                         "region, or flux through a wall or the surface of a region"),
            std::string::npos)
      << run.err;
}

TEST(Sensors, BetweenWhatDoesNotTouchAreRefused) {
  const CaseFolder folder(block_case("[directions]\nset = \"product\"\norder = 2\n"));
  const Outcome run = etendue_says(
      {"run", folder.file(), "--set", "sensor.1.beyond=\"mirror\"", "--set", "sensor.2.beyond=\"lamp\""});
  EXPECT_EQ(run.code, ExitCode::input_error);
  EXPECT_NE(
      run.err.find("= mirror: the sensor \"sides\" measures between block and this, which do not touch"),
      std::string::npos)
      << run.err;
  EXPECT_NE(
      run.err.find("= lamp: the sensor \"back\" names a region or wall that the mesh does not have; use "),
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
