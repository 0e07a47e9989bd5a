// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace etendue {

/// Cuts a simplex along a plane: `use(part, measure)` gets simplexes that fill it, none on both sides.
/// `height` has the signed distances of its corners from the plane; those up to `touching` count as in it.
template <std::size_t corners, class Use>
void cut_simplex(const std::array<std::array<double, corners>, corners>& simplex,
                 std::array<double, corners> height, double touching, double measure, const Use& use) {
  const auto [lowest, highest] = std::ranges::minmax_element(height);
  if (*lowest >= -touching || *highest <= touching) return use(simplex, measure);
  const auto below = static_cast<std::size_t>(lowest - height.begin());
  const auto above = static_cast<std::size_t>(highest - height.begin());
  const double fraction = height[above] / (height[above] - height[below]);
  auto upper = simplex, lower = simplex;
  for (std::size_t k = 0; k < corners; ++k)
    upper[below][k] = lower[above][k] =
        simplex[above][k] + fraction * (simplex[below][k] - simplex[above][k]);
  std::array<double, corners> upper_height = height;
  upper_height[below] = 0;
  height[above] = 0;
  cut_simplex<corners>(upper, upper_height, touching, fraction * measure, use);
  cut_simplex<corners>(lower, height, touching, (1 - fraction) * measure, use);
}

}  // namespace etendue
