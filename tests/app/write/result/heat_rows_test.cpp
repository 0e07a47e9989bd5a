// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/heat_rows.h"

#include <gtest/gtest.h>

#include "app/write/csv/tables.h"
#include "tests/app/write/sample_run.h"

namespace etendue::heat_rows_test {
namespace {

TEST(HeatRows, AddUpTheBandsOfWallsAndRegions) {
  const test::SampleRun run({"red", "green"});
  const RunResult result = run.result();
  const std::vector<HeatRow> rows = heat_rows(result);
  ASSERT_EQ(rows.size(), 4u);
  const WallPower& floor = result.walls[0][0];
  EXPECT_TRUE(rows[0].is_wall);
  EXPECT_EQ(rows[0].name, "floor");
  EXPECT_NEAR(rows[0].net, 2 * (floor.incoming - floor.outgoing), 1e-15);
  EXPECT_NEAR(rows[0].absorbed - rows[0].emitted, rows[0].net, 1e-15);
  EXPECT_NEAR(rows[0].density(), rows[0].net / floor.area, 1e-15);
  const RegionPower& low = result.regions[0][0];
  EXPECT_FALSE(rows[2].is_wall);
  EXPECT_EQ(rows[2].name, "low");
  EXPECT_NEAR(rows[2].net, 2 * (low.emitted - low.absorbed), 1e-15);
  EXPECT_NEAR(rows[2].density(), rows[2].net / low.volume, 1e-15);
}

TEST(HeatRows, AreATableOfWallsThenRegions) {
  const test::SampleRun run({"grey"});
  const std::string table = heat_csv(run.result());
  EXPECT_EQ(table.substr(0, table.find('\n')), "kind,name,extent,emitted,absorbed,net,density,temperature");
  EXPECT_NE(table.find("\nwall,floor,1,"), std::string::npos);
  EXPECT_LT(table.find("\nwall,sides,"), table.find("\nregion,low,0.5,"));
}

}  // namespace
}  // namespace etendue::heat_rows_test
