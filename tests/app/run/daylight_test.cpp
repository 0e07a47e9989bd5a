// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "tests/app/readings/sensor_table.h"
#include "tests/app/run/box_case.h"
#include "tests/app/run/small_case.h"

namespace etendue::daylight_test {
namespace {

using std::numbers::pi;
using test::box_case;
using test::CaseFolder;
using test::etendue_says;
using test::Outcome;
using test::rows_of;
using test::text_of;

/// A black box under an open roof, with a light and sensors.
std::string court(const std::string& more) {
  return box_case({.size = "[2, 1, 1]",
                   .walls = "zmax = \"roof\"",
                   .bands = "names = [\"blue-green\", \"yellow\"]\nedges = [450, 550, 600]"},
                  "[walls.\"*\"]\n" + more);
}

const std::string even_sky =
    "[[light]]\nkind = \"sky\"\nname = \"sky\"\nradiance = [1, 2]\nwalls = [\"roof\"]\n";
const std::string desk = R"([[sensor]]
name = "desk"
kind = "grid"
position = [0, 0, 0]
along = [2, 0, 0]
across = [0, 1, 0]
parts = [3, 1]
daylight_factor = true
)";

/// Configuration factor of a rectangle of sides x and y, one corner of which stands above the point of a
/// parallel plane at the distance 1 (Hopkinson, Petherbridge and Longmore 1966, uniform sky; Howell B-3).
double corner_factor(double x, double y) {
  const double a = std::sqrt(1 + x * x), b = std::sqrt(1 + y * y);
  return (x / a * std::atan(y / a) + y / b * std::atan(x / b)) / (2 * pi);
}

/// Of the roof, for a point of the floor.
double roof_factor(double x, double y) {
  return corner_factor(x, y) + corner_factor(2 - x, y) + corner_factor(x, 1 - y) +
         corner_factor(2 - x, 1 - y);
}

// CIE 171:2006, 5.9, but for a uniform sky: the sky component under an unglazed roof opening.
TEST(DaylightFactor, IsTheConfigurationFactorOfAnOpeningToAnEvenSky) {
  const CaseFolder folder(court(even_sky + desk));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  const double end = roof_factor(1. / 3, 0.5), middle = roof_factor(1, 0.5);
  const double mean = (2 * end + middle) / 3;
  for (const std::string band : {"blue-green", "yellow", "photopic"}) {
    const std::string desk_in_band = "desk " + band;
    EXPECT_NEAR(rows[desk_in_band + " daylight_factor_mean %"].at(2), 100 * mean, 1e-6);
    EXPECT_NEAR(rows[desk_in_band + " daylight_factor_least %"].at(2), 100 * end, 1e-6);
    EXPECT_NEAR(rows[desk_in_band + " daylight_factor_most %"].at(2), 100 * middle, 1e-6);
    EXPECT_NEAR(rows[desk_in_band + " uniformity_u0 1"].at(2), end / mean, 1e-8);
    EXPECT_NEAR(rows[desk_in_band + " uniformity_ud 1"].at(2), end / middle, 1e-8);
  }
  EXPECT_NE(run.out.find("sensor desk: uniformity_u0 photopic 0.9"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("sensor desk: daylight_factor_mean photopic"), std::string::npos) << run.out;
}

// The sky of a table is relative to its own horizontal irradiance, 7/9 pi of the zenith's radiance for Moon
// and Spencer's (1942): a point that sees all of it but a sliver at the horizon has all of the daylight, as
// well as parts of 10 degrees say.
TEST(DaylightFactor, IsRelativeToTheSkyOfATable) {
  CaseFolder folder(court(R"([[light]]
kind = "sky"
name = "sky"
radiance = 1
distribution = "overcast.csv"
walls = ["roof"]
[[sensor]]
name = "top"
position = [1, 0.5, 0.9999]
normal = [0, 0, 1]
daylight_factor = true
)"));
  std::ofstream table(folder.path() / "overcast.csv");
  for (int degrees = 0; degrees <= 90; degrees += 5)
    table << degrees << ", " << (1 + 2 * std::cos(degrees * pi / 180)) / 3 << "\n";
  table.close();
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  EXPECT_NEAR(rows["top yellow irradiance W/m^2"].at(2), 7 * pi / 9, 2e-2);
  EXPECT_NEAR(rows["top yellow daylight_factor %"].at(2), 100, 0.3);
  EXPECT_NEAR(rows["top photopic daylight_factor %"].at(2), 100, 0.3);
}

// An instrument that looks up through the roof sees the sky, in parts of 10 degrees: at the zenith the mean
// of (1 + 2 cos)/3 over the first of them, 0.995.
TEST(TableSky, IsSeenByInstruments) {
  const CaseFolder folder(court(R"([[light]]
kind = "sky"
name = "sky"
radiance = 1
distribution = "overcast.csv"
walls = ["roof"]
[[sensor]]
name = "zenith"
kind = "radiance"
position = [1, 0.5, 0.5]
direction = [0, 0, 1]
[[sensor]]
name = "patch"
kind = "cone"
position = [1, 0.5, 0.9]
direction = [0, 0, 1]
angle = 60
[[sensor]]
name = "wall"
kind = "radiance"
position = [1, 0.5, 0.5]
direction = [0, 1, 0]
)"));
  std::ofstream table(folder.path() / "overcast.csv");
  for (int degrees = 0; degrees <= 90; degrees += 5)
    table << degrees << ", " << (1 + 2 * std::cos(degrees * pi / 180)) / 3 << "\n";
  table.close();
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  EXPECT_NEAR(rows["zenith yellow radiance W/(m^2 sr)"].at(0), 0.995, 2e-3);
  EXPECT_EQ(rows["zenith yellow radiance W/(m^2 sr)"].at(1), 0);
  // The mean of (1 + 2 mu)/3 over mu from 1/2 to 1.
  EXPECT_NEAR(rows["patch yellow radiance_mean W/(m^2 sr)"].at(2), 5. / 6, 5e-3);
  EXPECT_EQ(rows["wall yellow radiance W/(m^2 sr)"].at(2), 0);
}

// Below the horizon, where the table ends, a window to the side is dark. Eight degrees above it the radiance
// is that of the lowest ring, (1 + 2 cos)/3 in the mean, 0.391; a plane that looks down from a wall without
// any obstacle gets nothing.
TEST(TableSky, EndsAtTheHorizon) {
  const CaseFolder folder(court(R"([[light]]
kind = "sky"
name = "sky"
radiance = 1
distribution = "overcast.csv"
walls = ["xmin", "xmax", "ymin", "ymax"]
[[sensor]]
name = "above"
kind = "radiance"
position = [1, 0.5, 0.5]
direction = [1, 0, 0.1]
[[sensor]]
name = "below"
kind = "radiance"
position = [1, 0.5, 0.5]
direction = [1, 0, -0.01]
[[sensor]]
name = "down"
position = [1, 0.5, 0.5]
normal = [0, 0, -1]
)"));
  std::ofstream table(folder.path() / "overcast.csv");
  for (int degrees = 0; degrees <= 90; degrees += 5)
    table << degrees << ", " << (1 + 2 * std::cos(degrees * pi / 180)) / 3 << "\n";
  table.close();
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  EXPECT_NEAR(rows["above yellow radiance W/(m^2 sr)"].at(2), 0.391, 5e-3);
  EXPECT_EQ(rows["below yellow radiance W/(m^2 sr)"].at(2), 0);
  EXPECT_EQ(rows["down yellow irradiance W/m^2"].at(2), 0);
}

TEST(DaylightFactor, IsOfOneSkyAlone) {
  const std::string sun =
      "[[light]]\nkind = \"sun\"\nname = \"noon\"\ndirection = [0, 0, -1]\nirradiance = 1\nwalls = "
      "[\"roof\"]\n";
  const CaseFolder with_sun(court(even_sky + sun + desk)), without_sky(court(desk));
  const Outcome refused = etendue_says({"check", with_sun.file()});
  EXPECT_EQ(refused.code, ExitCode::input_error);
  EXPECT_NE(refused.err.find("daylight_factor = true: the light \"noon\" shines too"), std::string::npos)
      << refused.err;
  const Outcome dark = etendue_says({"check", without_sky.file()});
  EXPECT_NE(dark.err.find("the case has no sky; use one [[light]] of kind \"sky\""), std::string::npos)
      << dark.err;
}

}  // namespace
}  // namespace etendue::daylight_test
