// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>

#include "app/case/false_color.h"

namespace etendue {

/// The bytes of a PNG file of values [row from the top][column] in the colors of viridis, with the scale at
/// its right: a bar, numbers and a title such as "luminance [cd/m^2]". What is beyond the scale has the color
/// of its end; what is NaN is grey. Pictures lower than the scale needs have a margin below.
std::string false_color_png(std::array<int, 2> pixels, std::span<const double> values,
                            const FalseColor& scale, const std::string& title);

}  // namespace etendue
