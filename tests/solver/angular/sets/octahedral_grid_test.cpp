// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/sets/octahedral_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace etendue::octahedral_grid_test {
namespace {

std::vector<Vec3> random_directions(int count) {
  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  std::vector<Vec3> directions;
  for (int i = 0; i < count; ++i)
    directions.push_back(Vec3(normal(generator), normal(generator), normal(generator)).normalized());
  return directions;
}

/// Directions where faces, edges and corners of the octahedron meet.
std::vector<Vec3> special_directions() {
  std::vector<Vec3> directions;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) directions.push_back(Vec3(x, y, z).normalized());
  return directions;
}

TEST(OctahedralGrid, HasEachDirectionOnce) {
  for (const int n : {1, 2, 5, 12}) {
    const OctahedralGrid grid(n);
    ASSERT_EQ(grid.size(), static_cast<std::size_t>(4 * n * n + 2));
    std::set<std::array<double, 3>> seen;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const Vec3& w = grid.direction(i);
      EXPECT_NEAR(w.norm(), 1, 1e-15);
      EXPECT_TRUE(seen.insert({w.x() + 0.0, w.y() + 0.0, w.z() + 0.0}).second);
    }
  }
}

TEST(OctahedralGrid, ReproducesEveryDirection) {
  const OctahedralGrid grid(12);
  std::vector<Vec3> directions = random_directions(2000);
  const std::vector<Vec3> special = special_directions();
  ASSERT_EQ(special.size(), 26U);
  directions.insert(directions.end(), special.begin(), special.end());
  for (const int stride : {1, 2, 4})
    for (const Vec3& w : directions) {
      const OctahedralGrid::Weights found = grid.weights(w, stride);
      Vec3 sum = Vec3::Zero();
      double all = 0;
      for (std::size_t v = 0; v < 3; ++v) {
        EXPECT_GE(found.weight[v], 0);
        if (found.weight[v] == 0) continue;
        ASSERT_GE(found.point[v], 0);
        ASSERT_LT(static_cast<std::size_t>(found.point[v]), grid.size());
        const Vec3& point = grid.direction(static_cast<std::size_t>(found.point[v]));
        EXPECT_GT(point.dot(w), std::cos(2.5 * stride / 12));
        sum += found.weight[v] * point;
        all += found.weight[v];
      }
      EXPECT_LT((sum - w).norm(), 1e-14);
      EXPECT_GE(all, 1 - 1e-14);
      EXPECT_LT(all, 1 + 2.0 * stride * stride / 144);
    }
}

TEST(OctahedralGrid, FindsItsOwnPointsAlone) {
  const OctahedralGrid grid(8);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const OctahedralGrid::Weights found = grid.weights(grid.direction(i));
    double own = 0, others = 0;
    for (std::size_t v = 0; v < 3; ++v)
      (static_cast<std::size_t>(found.point[v]) == i ? own : others) += found.weight[v];
    EXPECT_NEAR(own, 1, 1e-13) << i;
    EXPECT_NEAR(others, 0, 1e-13) << i;
  }
}

// A coarser grid is a part of the finer.
TEST(OctahedralGrid, TakesTheSamePointsWithAStride) {
  const OctahedralGrid fine(12), coarse(3);
  for (const Vec3& w : random_directions(500)) {
    const OctahedralGrid::Weights a = fine.weights(w, 4), b = coarse.weights(w);
    for (std::size_t v = 0; v < 3; ++v) {
      EXPECT_NEAR(a.weight[v], b.weight[v], 1e-13);
      EXPECT_LT((fine.direction(static_cast<std::size_t>(a.point[v])) -
                 coarse.direction(static_cast<std::size_t>(b.point[v])))
                    .norm(),
                1e-14);
    }
  }
}

}  // namespace
}  // namespace etendue::octahedral_grid_test
