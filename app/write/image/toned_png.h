// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/observe/color/tone.h"
#include "solver/observe/color/white_balance.h"

namespace etendue {

/// Linear colors with their white made neutral.
std::vector<LinearColor> balanced(std::span<const LinearColor> colors, const WhiteBalance& white);

/// Bytes of sRGB, [row from the top][column][3], of linear colors that went through an exposure and a tone
/// curve; without an exposure through automatic_exposure().
std::vector<std::uint8_t> toned_bytes(std::span<const LinearColor> colors, std::optional<double> exposure,
                                      Tone tone);

/// The bytes of a PNG file of linear colors, [row from the top][column], that went through an exposure and a
/// tone curve: toned_bytes().
std::string toned_png(std::array<int, 2> pixels, std::span<const LinearColor> colors,
                      std::optional<double> exposure, Tone tone);

}  // namespace etendue
