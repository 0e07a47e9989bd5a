// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>

namespace etendue {

/// Work of all sweeps so far.
struct SweepCost {
  std::int64_t band_sweeps = 0;  ///< sweeps of single bands
  double processor_seconds = 0;  ///< of all threads, without their waiting
};

}  // namespace etendue
