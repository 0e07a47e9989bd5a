// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/observe/color/tone.h"
#include "solver/observe/color/white_balance.h"

namespace etendue {

/// Linear colors with their white made neutral.
std::vector<LinearColor> balanced(std::span<const LinearColor> colors, const WhiteBalance& white);

/// The bytes of a PNG file of linear colors, [row from the top][column], that went through an exposure and a
/// tone curve; without an exposure through automatic_exposure().
std::string toned_png(std::array<int, 2> pixels, std::span<const LinearColor> colors,
                      std::optional<double> exposure, Tone tone);

}  // namespace etendue
