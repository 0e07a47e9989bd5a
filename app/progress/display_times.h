// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

// Often enough to see that a program lives, seldom enough for a log and for a terminal [s].
inline constexpr double seconds_to_first_line = 1;
inline constexpr double seconds_between_lines = 5;
inline constexpr double seconds_between_drawings = 0.2;

}  // namespace etendue
