// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cmath>
#include <cstddef>
#include <numbers>

#include "solver/angular/sets/direction_set.h"

namespace etendue {

// The trapezoid rule on the circle. Half steps keep directions off the axes, and so out of the sides of
// boxes. Quadrants are mirror images to the last bit, and so are x and y.
DirectionSet directions_flatland(int order) {
  const int quarter = order / 4;
  const auto cosine = [order](int j) { return std::cos(2 * std::numbers::pi * (j + 0.5) / order); };
  std::vector<Vec3> directions;
  for (int j = 0; j < quarter; ++j) {
    const double x = cosine(j), y = cosine(quarter - 1 - j);
    for (const double sign_x : {1.0, -1.0})
      for (const double sign_y : {1.0, -1.0}) directions.emplace_back(sign_x * x, sign_y * y, 0);
  }
  const std::vector<double> weights(directions.size(), 2 * std::numbers::pi / order);
  return DirectionSet("flatland", order, directions, weights, AngularSpace::plane);
}

}  // namespace etendue
