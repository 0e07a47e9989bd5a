// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/refraction/polar_levels.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace etendue {
namespace {

/// Cosines of one level differ by rounding only.
constexpr double same_cosine = 1e-9;

}  // namespace

PolarLevels::PolarLevels(const DirectionSet& directions, const Vec3& axis)
    : level_of_(static_cast<std::size_t>(directions.count())) {
  std::vector<double> cosines;
  for (const Vec3& direction : directions.directions()) cosines.push_back(std::abs(direction.dot(axis)));
  std::vector<std::size_t> order(cosines.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return cosines[a] > cosines[b]; });
  for (const std::size_t m : order) {
    if (levels_.empty() || levels_.back().cosine - cosines[m] > same_cosine)
      levels_.push_back({cosines[m], 0});
    levels_.back().weight += directions.weights()[m];
    level_of_[m] = levels_.size() - 1;
  }
}

}  // namespace etendue
