// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>

namespace etendue {

/// Clock of elapsed time, which never goes back.
using WallClock = std::chrono::steady_clock;

/// Seconds from `start` until now.
inline double seconds_since(WallClock::time_point start) {
  return std::chrono::duration<double>(WallClock::now() - start).count();
}

}  // namespace etendue
