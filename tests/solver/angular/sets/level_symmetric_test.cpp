// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/angular/sets/direction_set.h"

namespace etendue::level_symmetric_test {
namespace {

using std::numbers::pi;

double first_level(const DirectionSet& set) {
  double smallest = 1;
  for (const Vec3& direction : set.directions()) smallest = std::min(smallest, std::abs(direction.x()));
  return smallest;
}

/// Lewis and Miller (1984), table 4-1: the first level, to all the digits given there.
TEST(LevelSymmetric, HasThePublishedLevels) {
  EXPECT_NEAR(first_level(directions_level_symmetric(2)), std::sqrt(1.0 / 3), 1e-15);
  EXPECT_NEAR(first_level(directions_level_symmetric(4)), 0.3500212, 5e-8);
  EXPECT_NEAR(first_level(directions_level_symmetric(6)), 0.2666355, 1e-7);
  EXPECT_NEAR(first_level(directions_level_symmetric(8)), 0.2182179, 5e-8);
  EXPECT_NEAR(first_level(directions_level_symmetric(12)), 0.1672126, 6e-8);
  EXPECT_NEAR(first_level(directions_level_symmetric(16)), 0.1389568, 1e-7);
}

/// The weight of the directions on these levels, as a part of an octant.
double weight_of(const DirectionSet& set, double x, double y) {
  for (std::size_t m = 0; m < set.directions().size(); ++m)
    if (std::abs(set.directions()[m].x() - x) < 1e-6 && std::abs(set.directions()[m].y() - y) < 1e-6 &&
        set.directions()[m].z() > 0)
      return set.weights()[m] * 2 / pi;
  return 0;
}

TEST(LevelSymmetric, HasThePublishedWeights) {
  const double edge = 0.2182179, next = 0.5773503;
  const DirectionSet eight = directions_level_symmetric(8);
  EXPECT_NEAR(weight_of(eight, edge, edge), 0.1209877, 5e-8);
  EXPECT_NEAR(weight_of(eight, edge, next), 0.0907407, 5e-8);
  EXPECT_NEAR(weight_of(eight, next, next), 0.0925926, 5e-8);
  // The smallest and largest of table 4-1.
  const DirectionSet twelve = directions_level_symmetric(12);
  const auto [low, high] = std::minmax_element(twelve.weights().begin(), twelve.weights().end());
  EXPECT_NEAR(*low * 2 / pi, 0.0258513, 6e-8);
  EXPECT_NEAR(*high * 2 / pi, 0.0707626, 6e-8);
}

TEST(LevelSymmetric, IntegratesEvenPowersUpToItsOrder) {
  for (int order = 2; order <= 16; order += 2) {
    const DirectionSet set = directions_level_symmetric(order);
    for (int power = 0; power <= order; power += 2) {
      double sum = 0;
      for (std::size_t m = 0; m < set.directions().size(); ++m)
        sum += set.weights()[m] * std::pow(set.directions()[m].z(), power);
      EXPECT_NEAR(sum, 4 * pi / (power + 1), 5e-14) << "S" << order << ", power " << power;
    }
  }
}

}  // namespace
}  // namespace etendue::level_symmetric_test
