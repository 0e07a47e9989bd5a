// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "solver/observe/color/band_color.h"
#include "solver/observe/color/white_balance.h"

namespace etendue {

/// Linear sRGB of each node, its white made neutral, [node][3], from values [node][band].
std::vector<double> linear_colors(const BandColor& rule, const WhiteBalance& white,
                                  std::span<const double> values, std::size_t bands);

/// How bright values are shown: `white` becomes 1 on the display, and what is brighter is clipped.
struct Exposure {
  double white = 1;
};

/// The white below which 95 % of the volume or area is darker, by luminance (Rec. 709 weights). `rgb` has
/// three values for each node; `weights` holds the volume or area of each group of `nodes_per_weight` nodes.
Exposure exposure_of(std::span<const double> rgb, std::span<const double> weights, int nodes_per_weight);

/// Eight bits with the sRGB transfer function (IEC 61966-2-1).
std::uint8_t display_value(double value, const Exposure& exposure);

/// All values, and how they came about in one line for the file.
std::vector<std::uint8_t> display_colors(std::span<const double> rgb, const Exposure& exposure);
std::string describe(const Exposure& exposure, const std::string& flux_unit);

}  // namespace etendue
