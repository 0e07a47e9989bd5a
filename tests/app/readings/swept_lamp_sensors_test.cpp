// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/app/readings/sensor_table.h"
#include "tests/app/run/small_case.h"

namespace etendue::swept_lamp_sensors_test {
namespace {

using test::CaseFolder;
using test::etendue_says;
using test::Outcome;
using test::text_of;

/// A point of 1 W in a black cube of side 1, left to the directions, and a sensor of the intensity through
/// the top.
std::string lamp_in_cube(const std::string& medium, const std::string& more = "") {
  return "[mesh]\nedge_length = 0.1\n[[mesh.box]]\nregion = \"air\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n"
         "[directions]\norder = 1\n[walls.\"*\"]\n[output]\ndirectory = \"results\"\n[media.air]\n" +
         medium +
         "[[light]]\nname = \"bulb\"\nkind = \"point\"\nposition = [0.5, 0.5, 0.5]\npower = 1\n"
         "uncollided = false\n"
         "[[sensor]]\nname = \"out\"\nkind = \"intensity\"\nwall = \"zmax\"\nparts = [24, 19]\n" +
         more;
}

/// Intensity through the top at 0 to 40 degrees from the vertical, in parts of P/(4 pi) exp(-kappa d) with d
/// the path from the lamp: the mean over directions that all meet the top, of lights along rays and of all.
struct PartLeaving {
  double uncollided = 0, collided = 0;
};

PartLeaving part_leaving(const CaseFolder& folder, double absorption) {
  constexpr double degree = std::numbers::pi / 180;
  std::istringstream table(text_of(std::filesystem::path(folder.results()) / "out.intensity.csv"));
  PartLeaving found;
  double exact = 0;
  std::string row;
  for (std::getline(table, row); std::getline(table, row);) {
    std::istringstream cells(row);
    std::vector<std::string> words;
    for (std::string word; std::getline(cells, word, ',');) words.push_back(word);
    const double polar = std::stod(words.at(0)) * degree;
    if (polar > 40.1 * degree) continue;
    found.uncollided += std::sin(polar) * std::stod(words.at(3));
    found.collided += std::sin(polar) * std::stod(words.at(4));
    exact += std::sin(polar) * std::exp(-absorption * 0.5 / std::cos(polar)) / (4 * std::numbers::pi);
  }
  return {found.uncollided / exact, found.collided / exact};
}

// A point that shines evenly sends P/(4 pi) in each direction, of which exp(-kappa d) leaves by a wall at the
// distance d. Left to the directions it shines from all of its cell.
TEST(SweptLampSensors, SeeTheIntensityOfAPointThatIsLeftToTheDirections) {
  for (const double absorption : {0., 1.}) {
    const CaseFolder folder(lamp_in_cube(fmt::format("absorption = {}\n", absorption)));
    const Outcome run = etendue_says({"run", folder.file()});
    ASSERT_EQ(run.code, ExitCode::done) << run.err;
    const PartLeaving part = part_leaving(folder, absorption);
    EXPECT_NEAR(part.collided, 1, 0.05) << "of cells of a tenth, rays to three points of a face";
    EXPECT_EQ(part.uncollided, 0);
  }
}

// A second lamp, along rays, at the same place: the two must not be taken for each other.
TEST(SweptLampSensors, TellLampsApartOfWhichOneIsLeftToTheDirections) {
  const std::string second =
      "[[light]]\nname = \"second\"\nkind = \"point\"\nposition = [0.5, 0.5, 0.5]\npower = 3\n"
      "[[sensor]]\nname = \"air\"\nkind = \"region\"\nregion = \"air\"\n";
  const CaseFolder folder(lamp_in_cube("absorption = 0.1\n", second));
  const Outcome run = etendue_says({"run", folder.file()});
  ASSERT_EQ(run.code, ExitCode::done) << run.err;
  const PartLeaving part = part_leaving(folder, 0.1);
  EXPECT_NEAR(part.uncollided, 3, 1e-6);
  EXPECT_NEAR(part.collided, 1, 0.05);
  auto rows = test::rows_of(text_of(std::filesystem::path(folder.results()) / "sensors.csv"));
  EXPECT_NEAR(rows["air grey emitted W"].at(0), 3, 1e-9) << "along rays";
  EXPECT_NEAR(rows["air grey emitted W"].at(1), 1, 1e-9) << "left to the directions";
}

}  // namespace
}  // namespace etendue::swept_lamp_sensors_test
