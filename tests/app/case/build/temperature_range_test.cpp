// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/temperature_range.h"

#include <gtest/gtest.h>

#include "app/case/build/build.h"
#include "app/case/temperatures.h"
#include "tests/app/case/case_text.h"

namespace etendue::temperature_range_test {
namespace {

std::string hot_air(const std::string& temperature) {
  return cube + "[media.air]\nabsorption = 1\ntemperature = " + temperature +
         "\n[walls.zmin]\ntemperature = 300\n";
}

TEST(TemperatureRange, IsThatOfRegionsAndWalls) {
  const Case input = case_of(hot_air("\"400 + 100*x\""), {"mesh.max_volume=0.01"});
  const auto ranges = temperature_ranges(input, build_mesh(input));
  ASSERT_EQ(ranges.size(), 2u);
  EXPECT_EQ(ranges[0].place, "air");
  EXPECT_NEAR(ranges[0].mean, 450, 1e-9);  // exact: linear, and the centroids carry the volumes
  EXPECT_EQ(ranges[0].lowest, 400);
  EXPECT_EQ(ranges[0].highest, 500);
  EXPECT_EQ(ranges[1].place, "zmin");
  EXPECT_EQ(ranges[1].lowest, 300);
  EXPECT_EQ(ranges[1].highest, 300);
}

// By the cells that hold gases, and how much of them the fit does not reach.
TEST(MolarRatioRange, IsThatOfCellsWithGases) {
  const auto with_ratio = [](const std::string& ratio) {
    return cube + "[bands]\nwsgg = \"bordbar\"\nmolar_ratio = " + ratio +
           "\n[media.air]\ngas_pressure = 0.2\ntemperature = 900\n[walls.zmin]\ntemperature = 300\n";
  };
  const auto range_of = [&](const std::string& ratio) {
    const Case input = case_of(with_ratio(ratio), {"mesh.max_volume=0.001"});
    return molar_ratio_range(input, build_mesh(input));
  };
  EXPECT_FALSE(range_of("2"));
  const auto range = range_of("\"4 * x + 2\"");
  ASSERT_TRUE(range);
  EXPECT_GT(range->lowest, 2);
  EXPECT_LT(range->lowest, 2.3);
  EXPECT_GT(range->highest, 5.7);
  EXPECT_LT(range->highest, 6);
  EXPECT_NEAR(range->beyond, 0.5, 0.05);
  EXPECT_EQ(range_of("\"3 - x\"")->beyond, 0);
  EXPECT_THROW(range_of("\"z < 0.001 ? 0/(x-x) : 1\""), InputError);  // at a hot wall alone
}

TEST(TemperatureRange, RefusesNegativeTemperaturesWithTheirPlace) {
  const Case input = case_of(hot_air("\"10 - 100*x\""));
  try {
    build_problem(input, build_mesh(input));
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.faults().size(), 1u);
    EXPECT_NE(error.faults().front().text.find("the temperature is -"), std::string::npos);
    EXPECT_NE(error.faults().front().text.find("in air; use kelvin, at least 0"), std::string::npos);
    EXPECT_EQ(error.faults().front().line, 9);
  }
}

// Above 0 at the centroids of coarse cells, not at their vertices.
TEST(TemperatureRange, RefusesNegativeTemperaturesOfVertices) {
  const Case input = case_of(hot_air("\"300 - 301*x\""));
  EXPECT_THROW(temperature_ranges(input, build_mesh(input)), InputError);
}

TEST(TemperatureRange, IsThereWhereTheCaseHasTemperatures) {
  EXPECT_TRUE(has_temperatures(case_of(hot_air("900"))));
  EXPECT_FALSE(has_temperatures(case_of(cube)));
}

}  // namespace
}  // namespace etendue::temperature_range_test
