// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/app/run/small_case.h"

namespace etendue {
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

}  // namespace
}  // namespace etendue
