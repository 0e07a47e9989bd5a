// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace etendue {

/// Adds factor times the values, entry by entry. There must be as many as there are sums.
inline void add_to(std::span<double> sums, std::span<const double> values, double factor = 1) {
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += factor * values[i];
}

/// 0 where there are none.
inline double largest_magnitude(std::span<const double> values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace etendue
