// SPDX-License-Identifier: AGPL-3.0-or-later
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/app/run/csv_table.h"
#include "tests/app/run/empty_cube.h"
#include "tests/app/run/small_case.h"

namespace etendue::radiosity_views_test {
namespace {

using test::CaseFolder;
using test::CsvTable;
using test::empty_cube;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::text_of;

std::vector<float> pixels_of(const std::filesystem::path& exr, const std::string& channel) {
  Imf::InputFile file(exr.c_str());
  const Imath::V2i last = file.header().dataWindow().max;
  const auto columns = static_cast<std::size_t>(last.x + 1), rows = static_cast<std::size_t>(last.y + 1);
  std::vector<float> values(columns * rows);
  Imf::FrameBuffer frame;
  frame.insert(channel, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                   columns * sizeof(float)));
  file.setFrameBuffer(frame);
  file.readPixels(0, last.y);
  return values;
}

const std::string instruments = R"([[camera]]
name = "front"
position = [0.5, -1.5, 0.6]
look_at = [0.5, 0.5, 0.5]
pixels = [24, 18]
[[sensor]]
name = "desk"
position = [0.4, 0.3, 0]
normal = [0, 0, 1]
[[sensor]]
name = "eye"
kind = "radiance"
position = [0.4, 0.3, 0.2]
direction = [0.3, -0.5, 0.2]
)";

// Radiance is constant in a furnace: so are the picture of it and what sensors read.
TEST(RadiosityViews, LooksAtAFurnace) {
  const CaseFolder folder(empty_cube() + instruments);
  const Outcome outcome = etendue_says({"run", folder.file(), "--output", folder.results(), "--set",
                                        "walls.floor.radiance=[0.8,0.8]", "--set", "walls.floor.diffuse=0.2",
                                        "--set", "walls.floor.uncollided=false", "--set",
                                        "walls.*.radiance=[0.2,0.7]", "--set", "walls.*.uncollided=false"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  const std::vector<double> values =
      CsvTable(text_of(folder.path() / "results/sensors.csv")).numbers("value");
  ASSERT_EQ(values.size(), 4U);
  for (const std::size_t band : {0, 1}) {
    EXPECT_NEAR(values[band], std::numbers::pi, 1e-6);
    EXPECT_NEAR(values[2 + band], 1, 1e-6);
  }
  int seen = 0;
  for (const std::string channel : {"radiance.red", "radiance.green"})
    for (const float value : pixels_of(folder.path() / "results/front.exr", channel)) {
      if (value == 0) continue;
      ++seen;
      EXPECT_NEAR(value, 1, 1e-6);
    }
  EXPECT_GT(seen, 300);
}

// A floor that is followed along rays brings its light exactly, whatever the patches; between black walls
// that is all there is. The picture is the same from the saved result.
TEST(RadiosityViews, FollowsLightsAlongRays) {
  const CaseFolder folder(empty_cube() + instruments);
  const Outcome outcome =
      etendue_says({"run", folder.file(), "--output", folder.results(), "--set", "walls.floor.diffuse=0",
                    "--set", "walls.floor.uncollided=true", "--set", "walls.*.diffuse=[0,0.5]", "--set",
                    "sensor.0.position=[0.4,0.3,1]", "--set", "sensor.0.normal=[0,0,-1]"});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  const std::vector<double> values =
      CsvTable(text_of(folder.path() / "results/sensors.csv")).numbers("value");
  // Four rectangles at a corner below the point, each with the factor of (8.8) in Howell's catalogue B-4.
  const auto corner = [](double x, double y) {
    const double p = std::hypot(1, x), q = std::hypot(1, y);
    return (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / 2;
  };
  EXPECT_NEAR(values[0], corner(0.4, 0.3) + corner(0.4, 0.7) + corner(0.6, 0.3) + corner(0.6, 0.7), 1e-9);
  EXPECT_GT(values[1], 0.5 * values[0]);
  const std::string picture = text_of(folder.path() / "results/front.exr");
  const Outcome again = etendue_says({"render", folder.results()});
  ASSERT_EQ(again.code, ExitCode::done) << again.err;
  EXPECT_EQ(text_of(folder.path() / "results/front.exr"), picture);
}

TEST(RadiosityViews, RefusesToLookForWhatThereIsNone) {
  const CaseFolder folder(empty_cube() + instruments);
  const Outcome layers = etendue_says({"run", folder.file(), "--set", "camera.0.errors=true"});
  EXPECT_EQ(layers.code, ExitCode::input_error);
  EXPECT_TRUE(has(layers.err, "there is none")) << layers.err;
  const CaseFolder account(empty_cube() +
                           "[[sensor]]\nname = \"all\"\nkind = \"region\"\nregion = \"air\"\n");
  const Outcome region = etendue_says({"run", account.file()});
  EXPECT_EQ(region.code, ExitCode::input_error);
  EXPECT_TRUE(has(region.err, "no directions of light to count")) << region.err;
}

}  // namespace
}  // namespace etendue::radiosity_views_test
