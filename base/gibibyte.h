// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

inline constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;  ///< [bytes]

}  // namespace etendue
