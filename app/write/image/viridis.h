// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace etendue {

/// The color map viridis of Smith, van der Walt and Firing (2015, CC0): sRGB, from dark blue at 0 to yellow
/// at 1, in which equal steps look equal and brightness rises throughout. Linear between every fifteenth of
/// its 256 colors, within 5 of 255. Values beyond 0 and 1 have the color of the end.
std::array<std::uint8_t, 3> viridis(double value);

}  // namespace etendue
