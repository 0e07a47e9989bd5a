// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/color/tone.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/order_statistics.h"

namespace etendue {
namespace {

constexpr double share_below_white = 0.95;
constexpr double reinhard_white = 4;

LinearColor in_gamut(LinearColor color) {
  const double least = *std::min_element(color.begin(), color.end());
  if (least >= 0) return color;
  const double grey = luminance(color);
  if (grey <= 0) return {0, 0, 0};
  for (double& value : color) value = grey + (value - grey) * grey / (grey - least);
  return color;
}

double aces(double x) { return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14); }

}  // namespace

LinearColor toned(const LinearColor& color, Tone tone) {
  LinearColor result = in_gamut(color);
  if (tone == Tone::reinhard) {
    const double grey = luminance(result);
    for (double& value : result) value *= (1 + grey / (reinhard_white * reinhard_white)) / (1 + grey);
  } else if (tone == Tone::aces) {
    for (double& value : result) value = aces(value);
  }
  for (double& value : result) value = std::isnan(value) ? 0 : std::clamp(value, 0.0, 1.0);
  return result;
}

double automatic_exposure(std::span<const LinearColor> colors) {
  std::vector<double> values;
  for (const LinearColor& color : colors)
    if (const double value = luminance(color); value > 0 && std::isfinite(value)) values.push_back(value);
  if (values.empty()) return 1;
  return 1 / quantile(std::move(values), share_below_white);
}

}  // namespace etendue
