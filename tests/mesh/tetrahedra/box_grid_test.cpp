// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/box_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <vector>

namespace etendue::box_grid_test {
namespace {

TEST(BoxGrid, CandidatesHoldEveryBoxAroundThePoint) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-3, 7);
  std::uniform_real_distribution<double> size(0, 1.5);
  std::vector<Box> boxes;
  for (int i = 0; i < 300; ++i) {
    const Vec3 low(place(random), place(random), place(random));
    boxes.emplace_back(low, low + Vec3(size(random), size(random), size(random)));
  }
  const BoxGrid grid(boxes, 0.01);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 point(place(random), place(random), place(random));
    const auto candidates = grid.candidates(point);
    EXPECT_TRUE(std::is_sorted(candidates.begin(), candidates.end()));
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      if (boxes[b].squaredExteriorDistance(point) > 0) continue;
      EXPECT_TRUE(std::binary_search(candidates.begin(), candidates.end(), static_cast<std::int32_t>(b)));
    }
  }
}

TEST(BoxGrid, ManyBoxesInASmallPartHaveFewCandidates) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 1e-4);
  std::vector<Box> boxes = {Box(Vec3(0, 0, 0), Vec3(4, 3, 2))};
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 low(1 + place(random), 1 + place(random), 1 + place(random));
    boxes.emplace_back(low, low + Vec3::Constant(2e-6));
  }
  const BoxGrid grid(boxes, 0);
  for (std::size_t b = 1; b < boxes.size(); b += 100) {
    const auto candidates = grid.candidates(boxes[b].center());
    EXPECT_LT(candidates.size(), 100u);
    EXPECT_EQ(candidates.front(), 0);
    EXPECT_TRUE(std::binary_search(candidates.begin(), candidates.end(), static_cast<std::int32_t>(b)));
  }
}

TEST(BoxGrid, BoxesInOnePlaceAreAllCandidates) {
  const std::vector<Box> boxes(1000, Box(Vec3(0, 0, 0), Vec3(1, 1, 1)));
  EXPECT_EQ(BoxGrid(boxes, 0).candidates({0.5, 0.5, 0.5}).size(), 1000u);
}

// The sides and the base of a cone in thin triangles, which overlap near its axis however fine the grid is.
TEST(BoxGrid, OfAFanTakesLittleTime) {
  std::vector<Box> boxes;
  const int count = 4000;
  for (int i = 0; i < count; ++i)
    for (const double top : {1.0, 0.0}) {
      Box box(Vec3(0, 0, top));
      for (const int at : {i, i + 1})
        box.extend(Vec3(std::cos(2 * M_PI * at / count), std::sin(2 * M_PI * at / count), 0));
      boxes.push_back(box);
    }
  const auto begun = std::chrono::steady_clock::now();
  const BoxGrid grid(boxes, 0);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(5));
  const auto candidates = grid.candidates(boxes[70].center());
  EXPECT_TRUE(std::binary_search(candidates.begin(), candidates.end(), 70));
}

TEST(BoxGrid, MarginReachesBeyondTheBox) {
  const std::vector<Box> boxes = {Box(Vec3(0, 0, 0), Vec3(1, 1, 0))};
  const BoxGrid grid(boxes, 0.1);
  EXPECT_EQ(grid.candidates({1.05, 0.5, 0.05}).size(), 1u);
  EXPECT_TRUE(grid.candidates({1.2, 0.5, 0}).empty());
}

TEST(BoxGrid, WithoutBoxesHasNoCandidates) { EXPECT_TRUE(BoxGrid({}, 1).candidates({0, 0, 0}).empty()); }

}  // namespace
}  // namespace etendue::box_grid_test
