// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace etendue {

inline constexpr int dot_columns = 5, dot_rows = 7;

/// Five columns of a printable ASCII character, from left to right; bit 0 is the upper dot. Others are a box.
const std::array<std::uint8_t, dot_columns>& dots_of(char character);

}  // namespace etendue
