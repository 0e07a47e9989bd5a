// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// TetGen takes points for one that are closer than this part of the scene's size.
inline constexpr double smallest_gap = 1e-8;

}  // namespace etendue
