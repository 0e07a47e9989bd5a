// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/lamp_light.h"

#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

#include "tests/app/readings/sensor_table.h"
#include "tests/app/run/box_case.h"
#include "tests/app/run/small_case.h"

namespace etendue::lamp_light_test {
namespace {

using std::numbers::pi;
using test::box_case;
using test::CaseFolder;
using test::etendue_says;
using test::Outcome;
using test::rows_of;
using test::text_of;

// On a ceiling 100 cd down at 2 m, and above the desk 800 lm in all directions at 1.5 m: 100/4 + 800/(4
// pi 1.5^2) lx.
TEST(LampLight, GivesTheLuxOfLampsInLumens) {
  const std::string lamps = R"([[light]]
name = "downlight"
kind = "point"
position = [1, 1, 2]
distribution = "lamp.ies"
[[light]]
name = "bulb"
kind = "point"
position = [1, 1, 1.5]
luminous_flux = 800
color_temperature = 2700
[[sensor]]
name = "desk"
position = [1, 1, 0]
normal = [0, 0, 1]
)";
  const CaseFolder folder(box_case(
      {.size = "[2, 2, 2]",
       .bands = "names = [\"blue\", \"green\", \"red\", \"infrared\"]\nedges = [400, 500, 600, 700, 1000]"},
      "[walls.\"*\"]\n" + lamps));
  // It shines up as well: that light is lost in the ceiling.
  std::ofstream(folder.path() / "lamp.ies")
      << "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 50\n0 180\n0\n100 100\n";
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  const auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  EXPECT_NEAR(rows.at("desk photopic illuminance lx").at(2), 25 + 800 / (4 * pi * 2.25), 1e-6);
  EXPECT_NE(run.out.find("lamp bulb: "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find(" 800 lm, "), std::string::npos) << run.out;
  const std::string summary = text_of(folder.path() / "results" / "summary.json");
  EXPECT_NE(summary.find("\"luminous_efficacy\""), std::string::npos);
}

// Just below the open top of a box all of a clear sky is seen, and a sun 30 degrees high sends half its
// illuminance down.
TEST(Daylight, GivesTheIlluminanceOfSkyAndSun) {
  const CaseFolder folder(
      box_case({.bands = "names = [\"blue\", \"green\", \"red\"]\nedges = [400, 500, 600, 700]"},
               R"([walls."*"]
[[light]]
name = "sky"
kind = "sky"
walls = ["zmax"]
cie_type = 12
illuminance = 12000
color_temperature = 9000
sun_position = { altitude = 30, azimuth = 180 }
[[light]]
name = "sun"
kind = "sun"
walls = ["zmax"]
illuminance = 60000
color_temperature = 5500
sun_position = { altitude = 30, azimuth = 180 }
[[sensor]]
name = "top"
position = [0.5, 0.5, 0.9999]
normal = [0, 0, 1]
)"));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  const auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  EXPECT_NEAR(rows.at("top photopic illuminance lx").at(2), 12000 + 30000, 1e-6);
  const std::string summary = text_of(folder.path() / "results" / "summary.json");
  EXPECT_NE(summary.find("\"level_illuminance\""), std::string::npos);
  EXPECT_NE(run.out.find("12000 lx on a level plane; CIE standard general sky 12, sun at altitude 30.00"),
            std::string::npos)
      << run.out;
}

// A beam 60 degrees aslant on a wall of 2 by 1 m: half of 3 W/m^2 on 2 m^2.
TEST(Daylight, IsNotTheBeamOfAWall) {
  const CaseFolder folder(box_case({.size = "[2, 1, 1]", .bands = "names = [\"red\"]\nedges = [600, 700]"},
                                   "[walls.zmin]\nbeam = { direction = [0, 0.8660254037844386, 0.5], "
                                   "irradiance = 3 }\n[walls.\"*\"]\n"));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  EXPECT_NE(run.out.find("beam zmin.beam: 3 W on its wall, 3 W/m^2 across it\n"), std::string::npos)
      << run.out;
  EXPECT_EQ(run.out.find("level plane"), std::string::npos) << run.out;
  EXPECT_EQ(text_of(folder.path() / "results" / "summary.json").find("\"daylight\""), std::string::npos);
}

// Vertical planes under a whole clear sky (type 12) with the sun 40 degrees high in the south, of what a
// level plane gets: the standard's formulas summed over 300 x 600 directions by a program of its own. The sky
// comes in some 200 parts.
TEST(Daylight, SendsTheSkyOfTheStandardToWalls) {
  std::string text = box_case({.bands = "names = [\"grey\"]"}, R"([walls."*"]
[[light]]
name = "sky"
kind = "sky"
cie_type = 12
irradiance = 1
sun_position = { altitude = 40, azimuth = 180 }
)");
  const struct {
    std::string name, normal;
    double irradiance;
  } planes[] = {{"level", "[0, 0, 1]", 1},
                {"south", "[0, -1, 0]", 1.05286},
                {"north", "[0, 1, 0]", 0.36582},
                {"east", "[1, 0, 0]", 0.52114}};
  for (const auto& plane : planes)
    text += "[[sensor]]\nname = \"" + plane.name +
            "\"\nposition = [0.5, 0.5, 0.5]\nnormal = " + plane.normal + "\n";
  const CaseFolder folder(text);
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  const auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  for (const auto& plane : planes)
    EXPECT_NEAR(rows.at(plane.name + " grey irradiance W/m^2").at(2), plane.irradiance,
                plane.name == "level" ? 1e-9 : 0.005)
        << plane.name;
}

}  // namespace
}  // namespace etendue::lamp_light_test
