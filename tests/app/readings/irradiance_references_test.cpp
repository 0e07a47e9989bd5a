// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "tests/app/readings/sensor_table.h"
#include "tests/app/run/small_case.h"
#include "tests/solver/observe/sensors/reference_rows.h"
#include "tests/support/checkout.h"

namespace etendue::irradiance_references_test {
namespace {

using std::numbers::pi;
using test::CaseFolder;
using test::etendue_says;
using test::reference_rows;
using test::ReferenceRow;

/// What a meter may be off by, of the value.
constexpr double allowed = 1e-6;

using Parameters = std::vector<double>;

std::string box(const std::string& low, const std::string& high, double edge) {
  return fmt::format(
      "[mesh]\nedge_length = {}\nquality = 1000\n[[mesh.box]]\nregion = \"air\"\nmin = {}\nmax = "
      "{}\n[walls.\"*\"]\n",
      edge, low, high);
}

/// A dark box over the plane z = 0 with a lamp in it.
std::string dark(const std::string& lamp) {
  return box("[-9, -9, 0]", "[9, 9, 9]", 18) + "[[light]]\nname = \"lamp\"\n" + lamp;
}

std::string disc(double radius, double height) {
  return dark(fmt::format(
      "kind = \"disc\"\nposition = [0, 0, {}]\ndirection = [0, 0, -1]\nradius = {}\nradiance = 1\n", height,
      radius));
}

/// The circle in which lines of sight from the origin touch a ball.
std::string outline(double radius, double distance) {
  const double share = radius / distance;
  return disc(radius * std::sqrt(1 - share * share), distance * (1 - share * share));
}

std::string rectangle(const std::array<double, 2>& middle, double along, double across, double height) {
  return dark(fmt::format(
      "kind = \"rectangle\"\nposition = [{}, {}, {}]\ndirection = [0, 0, -1]\nalong = [1, 0, 0]\nsize = [{}, "
      "{}]\nradiance = 1\n",
      middle[0], middle[1], height, along, across));
}

std::string sky(const std::string& walls) {
  return fmt::format("[[light]]\nname = \"sky\"\nkind = \"sky\"\nradiance = 1\nwalls = [{}]\n", walls);
}

std::string open_sky() {
  return box("[-2, -4, 0]", "[3, 1, 2]", 5) + sky(R"("xmin", "xmax", "ymin", "ymax", "zmax")");
}

/// A mesh of validation/benchmarks/occlusion one of whose walls shines.
std::string shining_wall(const std::string& file, int wall) {
  return fmt::format(
      "[mesh]\nsurface = \"{}\"\nmax_volume = 100\nquality = "
      "10\n[walls.{}]\nradiance = 1\nuncollided = true\n[walls.\"*\"]\n",
      test::checkout("validation/benchmarks/occlusion/" + file), wall);
}

/// A room of a reference, and where a meter is in it and faces.
struct Place {
  std::string room;
  std::string position = "[0, 0, 0]";
  std::string normal = "[0, 0, 1]";
};

std::string tilted(double degrees) {
  return fmt::format("[{}, 0, {}]", std::sin(degrees * pi / 180), std::cos(degrees * pi / 180));
}

std::optional<Place> place_of_irradiance(const std::string& name, const Parameters& p) {
  if (name == "disc_on_axis" && p[0] == 90) return Place{open_sky()};
  if (name == "disc_on_axis") return Place{disc(std::tan(p[0] * pi / 180), 1)};
  if (name == "disc_off_axis_parallel_plane") return Place{disc(p[0], p[1]), fmt::format("[{}, 0, 0]", p[2])};
  if (name == "sphere_source_facing") return Place{outline(p[0], p[1])};
  if (name == "rect_source_centred") return Place{rectangle({0, 0}, p[0], p[1], p[2])};
  if (name == "rect_source_corner") return Place{rectangle({p[0] / 2, p[1] / 2}, p[0], p[1], 1)};
  if (name == "point_source")
    return Place{
        dark(fmt::format("kind = \"point\"\nposition = [0, 0, {}]\npower = {}\n", p[1], 4 * pi * p[0])),
        "[0, 0, 0]", tilted(p[2])};
  if (name == "hemisphere_tilted_receiver") return Place{open_sky(), "[0, 0, 0]", tilted(p[1])};
  if (name == "cos_sky_moon_spencer")
    return Place{box("[-4, -4, 0]", "[4, 4, 4]", 4) + "radiance = \"(1 + 2*max(0, -wz))/3\"\n[walls.zmin]\n"};
  if (name == "lambert_polygon") return Place{shining_wall("triangle.smesh", 1)};
  return std::nullopt;
}

std::optional<Place> place_of_sky(const std::string& name, const Parameters& p) {
  if (name == "cylinder_well_bottom_centre") return Place{disc(p[0], p[1])};
  if (name == "box_well_bottom_centre" || name == "box_well_bottom_corner") {
    const bool middle = name == "box_well_bottom_centre";
    return Place{box("[0, 0, 0]", fmt::format("[{}, {}, {}]", p[0], p[1], p[2]), 1) + sky("\"zmax\""),
                 middle ? fmt::format("[{}, {}, 0]", p[0] / 2, p[1] / 2) : "[0, 0, 0]"};
  }
  if (name == "floor_point_near_infinite_wall")
    return Place{box("[0, -1e4, 0]", fmt::format("[50, 1e4, {}]", p[0]), 1e4) +
                     sky(R"("xmax", "ymin", "ymax", "zmax")"),
                 fmt::format("[{}, 0, 0]", p[1])};
  if (name == "infinite_trench_bottom_centre")
    return Place{box("[0, -1e4, 0]", fmt::format("[{}, 1e4, {}]", p[0], p[1]), 1e4) + sky("\"zmax\""),
                 fmt::format("[{}, 0, 0]", p[0] / 2)};
  if (name == "wedge_two_infinite_planes")
    return Place{shining_wall(fmt::format("wedge-{}.smesh", p[0]), 3), "[1e-7, 0, 0]"};
  // What its outline hides is taken from the half space below.
  if (name == "sphere_above_plane_point_below" && p[0] < p[1]) return Place{outline(p[0], p[1])};
  return std::nullopt;
}

/// Irradiance and fluence that the program's sensors show.
std::array<double, 2> measured(const Place& place) {
  const CaseFolder folder(
      place.room +
      "[media.\"*\"]\n[bands]\nnames = [\"light\"]\n[directions]\nset = \"product\"\norder = 2\n" +
      "[output]\ndirectory = \"results\"\n" +
      fmt::format("[[sensor]]\nname = \"plane\"\nposition = {}\nnormal = {}\n", place.position,
                  place.normal) +
      fmt::format("[[sensor]]\nname = \"ball\"\nkind = \"fluence\"\nposition = {}\n", place.position));
  const test::Outcome run = etendue_says({"run", folder.file()});
  EXPECT_EQ(run.code, ExitCode::done) << run.err;
  auto rows = test::rows_of(test::text_of(folder.path() / "results" / "sensors.csv"));
  return {rows["plane light irradiance W/m^2"].at(2), rows["ball light fluence W/m^2"].at(2)};
}

// Written as a case file and read by meters of the program: lamps that are discs, rectangles and points,
// skies, walls that shine.
TEST(Sensors, ShowTheIrradianceOfTheClosedForms) {
  int rows = 0;
  for (const ReferenceRow& row : reference_rows("irradiance.csv")) {
    const auto place = place_of_irradiance(row.name, row.parameters);
    ASSERT_TRUE(place) << row.name;
    EXPECT_NEAR(measured(*place)[0] / row.values.at(0), 1, allowed)
        << row.name << " " << testing::PrintToString(row.parameters);
    ++rows;
  }
  EXPECT_EQ(rows, 27);
}

// Parts of the sky's irradiance and of the half space that are open; a ball that touches the floor hides all
// of it, and what touches in a point is no mesh.
TEST(Sensors, ShowThePartOfTheSkyThatIsOpen) {
  int rows = 0;
  for (const ReferenceRow& row : reference_rows("ambient_occlusion.csv")) {
    const auto place = place_of_sky(row.name, row.parameters);
    if (!place) continue;
    auto [irradiance, fluence] = measured(*place);
    if (row.name == "sphere_above_plane_point_below")
      irradiance = pi - irradiance, fluence = 2 * pi - fluence;
    EXPECT_NEAR(irradiance / pi / row.values.at(0), 1, allowed)
        << row.name << " " << testing::PrintToString(row.parameters);
    EXPECT_NEAR(fluence / (2 * pi) / row.values.at(1), 1, allowed)
        << row.name << " " << testing::PrintToString(row.parameters);
    ++rows;
  }
  EXPECT_EQ(rows, 20);
}

}  // namespace
}  // namespace etendue::irradiance_references_test
