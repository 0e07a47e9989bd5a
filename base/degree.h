// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <numbers>

namespace etendue {

inline constexpr double one_degree = std::numbers::pi / 180;  ///< [rad]

}  // namespace etendue
