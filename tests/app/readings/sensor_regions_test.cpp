// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/readings/sensors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/app/readings/sensor_table.h"
#include "tests/app/run/csv_table.h"
#include "tests/app/run/small_case.h"

namespace etendue::sensor_regions_test {
namespace {

using std::numbers::pi;
using test::CaseFolder;
using test::CsvTable;
using test::etendue_says;
using test::Outcome;
using test::rows_of;
using test::text_of;

/// The small case with the account of its region.
std::string account_case(const std::string& more) {
  return test::small_case() +
         "[solve]\ntolerance = 1e-10\n[[sensor]]\nname = \"all\"\nkind = \"region\"\nregion = "
         "\"smoke\"\n" +
         more;
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
  const CsvTable regions(text_of(folder.path() / "results" / "regions.csv"));
  const CsvTable walls(text_of(folder.path() / "results" / "walls.csv"));
  const auto value = [&](const std::string& sensor, const std::string& quantity) {
    return rows[sensor + " grey " + quantity].at(2);
  };
  const double balance =
      regions.number({"block", "grey"}, "emitted") - regions.number({"block", "grey"}, "absorbed");
  EXPECT_GT(balance, 0.01);
  EXPECT_NEAR(value("surface", "flux_net W") / balance, 1, 1e-8);
  EXPECT_NEAR(value("sides", "flux_net W") / balance, 1, 1e-8) << "mirrors take nothing";
  EXPECT_NEAR(value("back", "flux_forward W") / value("sides", "flux_backward W"), 1, 1e-12);
  EXPECT_NEAR(value("mirror", "flux_forward W") / walls.number({"mirror", "grey"}, "incoming"), 1, 1e-8);
  EXPECT_NEAR(value("mirror", "flux_backward W") / walls.number({"mirror", "grey"}, "outgoing"), 1, 1e-8);
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
  const CsvTable walls(text_of(folder.path() / "results" / "walls.csv"));
  EXPECT_NEAR(rows["wall grey flux_forward W"].at(2) / walls.number({"xmax", "grey"}, "incoming"), 1, 1e-8);
  EXPECT_NEAR(rows["wall grey flux_backward W"].at(2) / walls.number({"xmax", "grey"}, "outgoing"), 1, 1e-8);
  const CsvTable probes(text_of(folder.path() / "results" / "probes.csv"));
  EXPECT_NEAR(rows["around grey fluence W/m^2"].at(2) / probes.numbers("fluence").at(0), 1, 1e-10);
  EXPECT_NEAR(rows["point grey irradiance W/m^2"].at(2) / probes.numbers("irradiance").at(0), 1, 1e-10);
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

}  // namespace
}  // namespace etendue::sensor_regions_test
