// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/app/run/csv_table.h"
#include "tests/app/run/small_case.h"

namespace etendue::heat_report_test {
namespace {

using test::CaseFolder;
using test::etendue_says;
using test::has;
using test::Outcome;

/// A heated gas in a unit cube: its roof is warm, its floor cold, its sides adiabatic.
const std::string heated_cube = R"([mesh]
edge_length = 0.5
[[mesh.box]]
region = "gas"
min = [0, 0, 0]
max = [1, 1, 1]
[media.gas]
absorption = 1
heat_source = 3000
[walls.zmin]
temperature = 300
[walls.zmax]
temperature = 500
[walls."*"]
emissivity = 0.5
heat_flux = 0
[directions]
set = "product"
order = 2
[output]
directory = "results"
)";

TEST(HeatReport, CountsNoLightsWhereWallsReradiate) {
  const CaseFolder folder(heated_cube);
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "3000 W leave the media, and 3000 W enter the walls")) << outcome.out;
}

TEST(HeatReport, CountsTheLights) {
  const CaseFolder folder(
      heated_cube + "[[light]]\nname = \"lamp\"\nkind = \"point\"\nposition = [0.5, 0.5, 0.5]\npower = 70\n");
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "3000 W leave the media, 70 W come from lights, and 3070 W enter the walls"))
      << outcome.out;
}

/// The same gas conducts; a part of its heat comes from a lamp, and the roof shines along rays.
const std::string conducting_cube = [] {
  std::string text = heated_cube;
  text.replace(text.find("heat_source"), 0, "conductivity = 2\n");
  text.replace(text.find("temperature = 500"), 0, "uncollided = true\n");
  return text + "[[light]]\nname = \"lamp\"\nkind = \"point\"\nposition = [0.5, 0.5, 0.5]\npower = 1000\n";
}();

/// Over all walls.
double sum_of_walls(const test::CsvTable& heat, const std::string& column) {
  double sum = 0;
  for (const char* wall : {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"})
    sum += heat.number({"wall", wall}, column);
  return sum;
}

TEST(HeatReport, AddsUpConductionAndRadiation) {
  const CaseFolder folder(conducting_cube);
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err << outcome.out;
  EXPECT_TRUE(has(outcome.out, "are conducted into the walls")) << outcome.out;
  EXPECT_TRUE(has(outcome.out, "steps to the temperatures")) << outcome.out;
  const test::CsvTable heat(test::text_of(folder.path() / "results" / "heat.csv"));
  const double conducted = sum_of_walls(heat, "conducted");
  EXPECT_GT(conducted, 100);
  EXPECT_NEAR((conducted + sum_of_walls(heat, "net")) / 4000, 1, 2e-3);
}

}  // namespace
}  // namespace etendue::heat_report_test
