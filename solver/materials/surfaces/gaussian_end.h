// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// Where exp(-x^2) is below rounding.
inline constexpr double gaussian_end = 6.5;

}  // namespace etendue
