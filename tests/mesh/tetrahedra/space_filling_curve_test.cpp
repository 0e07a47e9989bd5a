// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/space_filling_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace etendue::space_filling_curve_test {
namespace {

TEST(SpaceFillingCurve, StepsFromNeighbourToNeighbour) {
  // All points of a corner of the lattice; the curve fills the corner before it leaves.
  constexpr std::uint32_t side = 8;
  std::vector<std::pair<std::uint64_t, std::array<int, 3>>> points;
  for (std::uint32_t x = 0; x < side; ++x)
    for (std::uint32_t y = 0; y < side; ++y)
      for (std::uint32_t z = 0; z < side; ++z)
        points.push_back(
            {hilbert_key(x, y, z), {static_cast<int>(x), static_cast<int>(y), static_cast<int>(z)}});
  std::sort(points.begin(), points.end());
  EXPECT_EQ(points.front().first, 0u);
  EXPECT_EQ(points.back().first, side * side * side - 1);
  for (std::size_t i = 1; i < points.size(); ++i) {
    int steps = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      steps += std::abs(points[i].second[axis] - points[i - 1].second[axis]);
    EXPECT_EQ(steps, 1);
  }
}

TEST(SpaceFillingCurve, KeepsTheOrderOfCoincidentPoints) {
  const std::vector<Vec3> points(4, Vec3(1, 2, 3));
  EXPECT_EQ(curve_order(points), (std::vector<std::int32_t>{0, 1, 2, 3}));
  EXPECT_TRUE(curve_order({}).empty());
}

}  // namespace
}  // namespace etendue::space_filling_curve_test
