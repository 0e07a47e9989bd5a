// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "solver/observe/color/photometry.h"
#include "solver/observe/sensors/glare.h"
#include "solver/uncollided/closed_form/polygon_irradiance.h"
#include "tests/app/readings/sensor_table.h"
#include "tests/app/run/box_case.h"
#include "tests/app/run/small_case.h"

namespace etendue::glare_sensor_test {
namespace {

using std::numbers::pi;
using test::box_case;
using test::CaseFolder;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::rows_of;
using test::text_of;

/// A room of even radiance all around with a lamp at the ceiling, and an observer.
std::string room(const std::string& keys) {
  return box_case(
      {.size = "[6, 4, 3]", .edge_length = 1.5, .bands = "names = [\"light\"]\nedges = [500, 600]"},
      R"([walls."*"]
radiance = 0.3
uncollided = false
[[light]]
kind = "rectangle"
name = "lamp"
position = [4, 2, 2.9]
direction = [0, 0, -1]
along = [1, 0, 0]
size = [1.2, 0.6]
radiance = 60
[[sensor]]
name = "eye"
kind = "glare"
position = [1, 2, 1.2]
direction = [1, 0, 0]
)" + keys);
}

/// Closed forms of this room: it has the luminance L_w everywhere, the lamp L more within its solid
/// angle, that of its two triangles.
struct ByHand {
  double efficacy = Photometry({{"light"}, {500, 600}}).efficacy()[0];
  double wall = 0.3 * efficacy, lamp = 60.3 * efficacy;
  double solid_angle = 0, across = 0, position = 0;

  ByHand() {
    const Vec3 eye(1, 2, 1.2);
    const std::array<Vec3, 4> c = {Vec3(3.4, 1.7, 2.9) - eye, Vec3(4.6, 1.7, 2.9) - eye,
                                   Vec3(4.6, 2.3, 2.9) - eye, Vec3(3.4, 2.3, 2.9) - eye};
    solid_angle = triangle_solid_angle({c[0], c[1], c[2]}) + triangle_solid_angle({c[0], c[2], c[3]});
    across = polygon_irradiance(c, Vec3::UnitX());
    // Guth's index at the middle of the lamp as it is seen, straight above the line of sight: tau = 0.
    Vec3 middle = Vec3::Zero();
    constexpr int steps = 40;
    for (int i = 0; i < steps; ++i)
      for (int k = 0; k < steps; ++k) {
        const Vec3 at((i + 0.5) / steps * 1.2 + 2.4, (k + 0.5) / steps * 0.6 - 0.3, 1.7);
        middle += at / std::pow(at.norm(), 4);
      }
    const double sigma = std::acos(middle.normalized().x()) * 180 / pi;
    position = std::exp((35.2 - 1.22) * 1e-3 * sigma + 21e-5 * sigma * sigma);
  }
  double background() const { return wall * (1 - across / pi); }
  double contrast() const { return lamp * lamp * solid_angle / (position * position); }
};

TEST(GlareSensor, RatesARectangularLampAsByHand) {
  const CaseFolder folder(room("sources = \"lights\"\n"));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  const ByHand known;
  EXPECT_EQ(rows["eye photopic glare_sources 1"].at(2), 1);
  EXPECT_NEAR(rows["eye photopic background_luminance cd/m^2"].at(2) / known.background(), 1, 2e-3);
  const double ugr = 8 * std::log10(0.25 / known.background() * known.contrast());
  EXPECT_GT(ugr, 25);
  EXPECT_NEAR(rows["eye photopic ugr 1"].at(2), ugr, 0.1);
  // What the rectangle adds to the radiance of the walls.
  const double at_eye = pi * known.wall + 60 * known.efficacy * known.across;
  EXPECT_NEAR(rows["eye photopic illuminance lx"].at(2) / at_eye, 1, 1e-3);
  const double dgp =
      5.87e-5 * at_eye + 9.18e-2 * std::log10(1 + known.contrast() / std::pow(at_eye, 1.87)) + 0.16;
  EXPECT_GT(at_eye, 1000);
  EXPECT_NEAR(rows["eye photopic dgp 1"].at(2), dgp, 1e-3);
  EXPECT_NE(run.out.find("sensor eye: ugr photopic"), std::string::npos) << run.out;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "results" / "eye.glare.png"));
  const std::string sources = text_of(folder.path() / "results" / "eye.glare.csv");
  EXPECT_EQ(sources.substr(0, sources.find('\n')), "source,x,y,z,luminance,solid_angle,position_index");
}

// The lamp is 2000 times as bright as 2 lx would be; above the threshold it is the same source.
TEST(GlareSensor, FindsSourcesByTheirLuminance) {
  const CaseFolder folder(
      room("threshold = 2000\n[[sensor]]\nname = \"dull\"\nkind = \"glare\"\nposition = [1, "
           "2, 1.2]\ndirection = [1, 0, 0]\nthreshold = 1e6\n"));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  const ByHand known;
  EXPECT_EQ(rows["eye photopic glare_sources 1"].at(2), 1);
  EXPECT_NEAR(rows["eye photopic ugr 1"].at(2), 8 * std::log10(0.25 / known.background() * known.contrast()),
              0.1);
  EXPECT_EQ(rows["dull photopic glare_sources 1"].at(2), 0);
  EXPECT_EQ(rows["dull photopic ugr 1"].at(2), 0);
}

// CIE 147:2002: a lamp without an extent has the area of 0.005 m^2, so L^2 omega = 200 I^2/r^2.
TEST(GlareSensor, CountsPointsAsSmallSources) {
  std::string text = room("sources = \"lights\"\n");
  const std::size_t first = text.find("[[light]]");
  text.replace(first, text.find("[[sensor]]") - first,
               "[[light]]\nkind = \"point\"\nname = \"bulb\"\nposition = [4, 2, 2.2]\npower = 12\n");
  const CaseFolder folder(text);
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = rows_of(text_of(folder.path() / "results" / "sensors.csv"));
  const ByHand known;
  const double sigma = std::atan(1.0 / 3) * 180 / pi;
  const double index = std::exp((35.2 - 1.22) * 1e-3 * sigma + 21e-5 * sigma * sigma);
  const double intensity = 12 * known.efficacy / (4 * pi);
  const double ugr = 8 * std::log10(0.25 / known.wall * 200 * intensity * intensity / 10 / (index * index));
  EXPECT_NEAR(rows["eye photopic ugr 1"].at(2), ugr, 0.01);
}

TEST(GlareSensor, NeedsAnEye) {
  std::string text = room("");
  text.replace(text.find("edges = [500, 600]"), 18, "");
  const CaseFolder folder(text);
  const Outcome refused = etendue_says({"check", folder.file()});
  EXPECT_EQ(refused.code, ExitCode::input_error);
  EXPECT_NE(refused.err.find("glare needs bands that the eye sees; use bands.edges"), std::string::npos)
      << refused.err;
}

TEST(GlareSensor, TellsPlainNumbersWithoutAUnitAndWhereNothingGlares) {
  const CaseFolder folder(room("sources = \"lights\"\n"));
  const std::string lit = etendue_says({"run", folder.file()}).out;
  EXPECT_TRUE(has(lit, "sensor eye: glare_sources photopic 1\n")) << lit;
  const CaseFolder faint(room("threshold = 1e9\n"));
  const std::string dark = etendue_says({"run", faint.file()}).out;
  EXPECT_TRUE(has(dark, "sensor eye: ugr photopic no sources\n")) << dark;
}

}  // namespace
}  // namespace etendue::glare_sensor_test
