// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace etendue {

/// A function and its derivative at a point.
struct ValueAndSlope {
  double value = 0;
  double slope = 0;
};

/// At x, a function that has the values `ys` at `xs`, which rise, and is linear between; beyond them it has
/// the value of the nearest.
inline ValueAndSlope piecewise_linear(std::span<const double> xs, std::span<const double> ys, double x) {
  const auto above = std::ranges::upper_bound(xs, x);
  if (above == xs.begin()) return {ys.front(), 0};
  if (above == xs.end()) return {ys.back(), 0};
  const auto i = static_cast<std::size_t>(above - xs.begin());
  const double width = xs[i] - xs[i - 1];
  return {std::lerp(ys[i - 1], ys[i], (x - xs[i - 1]) / width), (ys[i] - ys[i - 1]) / width};
}

}  // namespace etendue
