// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/csv/tables.h"

#include <gtest/gtest.h>

#include "tests/app/write/sample_run.h"

namespace etendue::tables_test {
namespace {

TEST(Tables, ProbesHaveARowForEachPointAndBand) {
  const test::SampleRun run({"red", "green"});
  EXPECT_EQ(probes_csv(run.result()),
            "probe,index,x,y,z,band,fluence,flux_x,flux_y,flux_z,irradiance\n"
            "axis,0,0.5,0.25,0.1,red,0.3333333333333333,1,2,3,\n"
            "axis,0,0.5,0.25,0.1,green,0.3333333333333333,1,2,3,\n"
            "\"a \"\"b\"\", c\",3,0,0,0,red,0,0,0,0,0.1\n"
            "\"a \"\"b\"\", c\",3,0,0,0,green,0,0,0,0,0.1\n");
}

TEST(Tables, NetPowerOfAWallIsIncomingMinusOutgoing) {
  const test::SampleRun run({"grey"});
  const std::string table = walls_csv(run.result());
  EXPECT_EQ(table.substr(0, table.find('\n')), "wall,band,area,irradiance_mean,incoming,outgoing,net");
  EXPECT_NE(table.find("\nfloor,grey,1,0.1,0.7,0.4,0.29999999999999993\n"), std::string::npos);
  EXPECT_NE(table.find("\nsides,grey,1,0.1,0.7,0.4,0.29999999999999993\n"), std::string::npos);
}

TEST(Tables, RegionsAndHistoryAreNamedByBand) {
  const test::SampleRun run({"red", "green"});
  const std::string regions = regions_csv(run.result());
  EXPECT_EQ(regions.substr(0, regions.find('\n')), "region,band,volume,fluence_mean,absorbed,emitted");
  EXPECT_NE(regions.find("\nhigh,green,0.5,1.1,0.3,0.2\n"), std::string::npos);
  EXPECT_EQ(history_csv(run.result()),
            "sweep,band,residual\n1,red,0.1\n1,green,0.1\n2,red,0.05\n2,green,0.05\n");
}

}  // namespace
}  // namespace etendue::tables_test
