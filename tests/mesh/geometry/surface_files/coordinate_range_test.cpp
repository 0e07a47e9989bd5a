// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/surface_files/coordinate_range.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace etendue::coordinate_range_test {
namespace {

std::string fault_of(const std::vector<Vec3>& points) {
  try {
    for (const Vec3& point : points) checked_range(point);
    check_extent(points);
    return "none";
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
}

TEST(CoordinateRange, TakesWhatProductsNeitherLoseNorOverflow) {
  EXPECT_EQ(fault_of({}), "none");
  EXPECT_EQ(fault_of({{1e60, 0, -1e60}, {0, 1, 0}}), "none");
  EXPECT_EQ(fault_of({{0, 0, 0}, {0, 0, -1e-50}}), "none");
}

TEST(CoordinateRange, RefusesTheRestWithThePoint) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(fault_of({{1, 2, 3}, {0, -1e160, 0}}),
            "point (0, -1e+160, 0), scaled: use coordinates up to 1e+60");
  EXPECT_EQ(fault_of({{infinite, 0, 0}}), "point (inf, 0, 0), scaled: use coordinates up to 1e+60");
  EXPECT_EQ(fault_of({{0, 0, 0}, {1e-160, 0, 0}}),
            "all coordinates, scaled, are at most 1e-160: use a surface of at least 1e-50");
}

}  // namespace
}  // namespace etendue::coordinate_range_test
