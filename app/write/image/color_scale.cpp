// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/image/color_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

constexpr int most_ticks = 11;

/// Ends of a scale belong to it whatever rounding does to them.
constexpr double rounding = 1e-9;

}  // namespace

ColorScale::ColorScale(double least, double most, bool logarithmic)
    : least_(least), most_(most), logarithmic_(logarithmic) {}

double ColorScale::place_of(double value) const {
  if (!logarithmic_) return (value - least_) / (most_ - least_);
  return std::log(std::max(value, 0.0) / least_) / std::log(most_ / least_);
}

std::vector<ColorScale::Tick> ColorScale::ticks() const {
  return logarithmic_ ? logarithmic_ticks() : linear_ticks();
}

std::vector<ColorScale::Tick> ColorScale::linear_ticks() const {
  const double power = std::pow(10, std::floor(std::log10((most_ - least_) / most_ticks)));
  double step = power;
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    step = factor * power;
    if ((most_ - least_) / step < most_ticks) break;
  }
  std::vector<Tick> ticks;
  for (double i = std::ceil(least_ / step - rounding); i * step <= most_ + rounding * step; ++i)
    ticks.push_back({place_of(i * step), fmt::format("{:.6g}", i * step + 0.0)});  // no -0
  return ticks;
}

// Powers of ten and their 2 and 5 times, or powers alone, or every second, third … of them: the first choice
// that is not too many.
std::vector<ColorScale::Tick> ColorScale::logarithmic_ticks() const {
  const int first = static_cast<int>(std::floor(std::log10(least_) + rounding));
  const int last = static_cast<int>(std::ceil(std::log10(most_) - rounding));
  for (int stride = 0;; ++stride) {
    std::vector<Tick> ticks;
    for (int exponent = first; exponent <= last; exponent += std::max(1, stride))
      for (const double factor : {1.0, 2.0, 5.0}) {
        if (stride > 0 && factor > 1) continue;
        const double value = factor * std::pow(10, exponent), place = place_of(value);
        if (place > -rounding && place < 1 + rounding) ticks.push_back({place, fmt::format("{:.6g}", value)});
      }
    if (ticks.size() <= most_ticks) return ticks;
  }
}

}  // namespace etendue
