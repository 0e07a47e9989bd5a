// SPDX-License-Identifier: AGPL-3.0-or-later
// Runs whose temperatures follow by iteration.
#include <gtest/gtest.h>

#include "tests/app/run/csv_table.h"
#include "tests/app/run/small_case.h"

namespace etendue {
namespace {

using test::CaseFolder;
using test::CsvTable;
using test::etendue_says;
using test::has;
using test::Outcome;
using test::text_of;

std::string cube_with(const std::string& rest) {
  return "[mesh]\nedge_length = 0.35\n[[mesh.box]]\nregion = \"gas\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n"
         "[directions]\nset = \"product\"\norder = 2\n[output]\ndirectory = \"results\"\n" +
         rest;
}

TEST(TemperaturesRun, ConductNoHeatThroughASheet) {
  const CaseFolder folder(
      cube_with("[[mesh.sheet]]\nfront = \"plate\"\nmin = [0.5, 0, 0]\nmax = [0.5, 1, 1]\n"
                "[media.gas]\nabsorption = 0\nconductivity = 1\n[walls.\"*\"]\ndiffuse = 1\n"
                "[walls.xmin]\ntemperature = 300\n[walls.xmax]\ntemperature = 400\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err << outcome.out;
  const CsvTable heat(text_of(folder.path() / "results" / "heat.csv"));
  EXPECT_NEAR(heat.number({"wall", "xmin"}, "conducted"), 0, 1e-3);
  EXPECT_NEAR(heat.number({"wall", "xmax"}, "conducted"), 0, 1e-3);
}

TEST(TemperaturesRun, AreSeenBySensorsOfRegions) {
  const CaseFolder folder(
      cube_with("[media.gas]\nabsorption = 1\nconductivity = 1\nheat_source = 1e4\n"
                "[walls.\"*\"]\ntemperature = 500\n[[sensor]]\nname = \"account\"\nkind = \"region\"\nregion "
                "= \"gas\"\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  ASSERT_EQ(outcome.code, ExitCode::done) << outcome.err << outcome.out;
  const CsvTable sensors(text_of(folder.path() / "results" / "sensors.csv"));
  const CsvTable regions(text_of(folder.path() / "results" / "regions.csv"));
  double emitted = 0;
  for (std::size_t row = 0; row < sensors.rows().size(); ++row)
    if (sensors.column("quantity")[row] == "emitted") emitted = sensors.numbers("value")[row];
  EXPECT_NEAR(emitted / regions.number({"gas"}, "emitted"), 1, 1e-6);
}

TEST(TemperaturesRun, WarnsOfLayersThatTheCellsMiss) {
  const std::string gas =
      "[media.gas]\nabsorption = 1\nheat_source = 1e4\n[walls.\"*\"]\ntemperature = 500\n";
  const CaseFolder folder(cube_with(gas));
  const auto says = [&](const char* conductivity) {
    return has(
        etendue_says({"run", folder.file(), "--set", std::string("media.gas.conductivity=") + conductivity})
            .out,
        "the layer in which conduction gives way");
  };
  EXPECT_TRUE(says("0.01"));
  EXPECT_FALSE(says("100"));
}

TEST(TemperaturesRun, WarnsBeyondTheRangeOfGrayGases) {
  const CaseFolder folder(cube_with(
      "[bands]\nwsgg = \"bordbar\"\nmolar_ratio = 1\n[media.gas]\ngas_pressure = 0.5\nheat_source = 5e6\n"
      "[walls.\"*\"]\ntemperature = 500\n"));
  const Outcome outcome = etendue_says({"run", folder.file()});
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.err << outcome.out;
  EXPECT_TRUE(has(outcome.out, "known up to 2400 K")) << outcome.out;
}

}  // namespace
}  // namespace etendue
