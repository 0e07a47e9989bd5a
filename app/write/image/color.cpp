// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/image/color.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

// Lamps are small; with this share of the domain below white they burn out and the rest is well exposed.
constexpr double share_below_white = 0.95;

struct WeightedValue {
  double value;
  double weight;
};

double percentile(std::vector<WeightedValue> values, double share) {
  std::sort(values.begin(), values.end(),
            [](const WeightedValue& a, const WeightedValue& b) { return a.value < b.value; });
  double total = 0;
  for (const WeightedValue& v : values) total += v.weight;
  double below = 0;
  for (const WeightedValue& v : values) {
    below += v.weight;
    if (below >= share * total) return v.value;
  }
  return 0;
}

/// Recommendation ITU-R BT.709: luminance of linear red, green and blue.
double luminance(double red, double green, double blue) {
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

}  // namespace

std::vector<double> linear_colors(const BandColor& rule, const WhiteBalance& white,
                                  std::span<const double> values, std::size_t bands) {
  std::vector<double> colors;
  colors.reserve(3 * (values.size() / bands));
  for (std::size_t at = 0; at < values.size(); at += bands) {
    const LinearColor color = white.of(rule.of(values.subspan(at, bands)));
    colors.insert(colors.end(), color.begin(), color.end());
  }
  return colors;
}

Exposure exposure_of(std::span<const double> rgb, std::span<const double> weights, int nodes_per_weight) {
  std::vector<WeightedValue> values;
  values.reserve(rgb.size() / 3);
  for (std::size_t node = 0; node < rgb.size() / 3; ++node) {
    const double value = luminance(rgb[3 * node], rgb[3 * node + 1], rgb[3 * node + 2]);
    if (std::isfinite(value))
      values.push_back({value, weights[node / static_cast<std::size_t>(nodes_per_weight)]});
  }
  const double white = percentile(std::move(values), share_below_white);
  return {white > 0 ? white : 1};
}

std::uint8_t display_value(double value, const Exposure& exposure) {
  if (!(value > 0)) return 0;  // NaN too
  const double linear = std::min(value / exposure.white, 1.0);
  // IEC 61966-2-1:1999, section 5.2.
  const double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

std::vector<std::uint8_t> display_colors(std::span<const double> rgb, const Exposure& exposure) {
  std::vector<std::uint8_t> colors(rgb.size());
  std::transform(rgb.begin(), rgb.end(), colors.begin(),
                 [&](double value) { return display_value(value, exposure); });
  return colors;
}

std::string describe(const Exposure& exposure, const std::string& flux_unit) {
  return fmt::format("sRGB, white = {:.4g} {} (95 % of the domain has less luminance), clipped",
                     exposure.white, flux_unit);
}

}  // namespace etendue
