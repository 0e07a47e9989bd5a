// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace etendue {

/// Returns whether a sum of squares is far from the ends of the range of numbers, so that overflow and
/// underflow did not change it. Neither zero nor NaN is.
inline bool is_safe_sum_of_squares(double sum) { return sum >= 1e-250 && sum <= 1e250; }

/// A power of two by which values up to `largest` in magnitude can be multiplied to be squared safely: the
/// product has the same digits. 1 where `largest` is zero or not finite.
inline double unit_for_squares(double largest) {
  if (!(largest > 0) || !std::isfinite(largest)) return 1;
  // Beyond 2^1020 the factor itself, or its inverse, would leave the range of numbers.
  return std::exp2(-std::clamp(std::floor(std::log2(largest)), -1020.0, 1020.0));
}

}  // namespace etendue
