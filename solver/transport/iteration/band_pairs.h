// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

namespace etendue {

// Numbers [band] of complex radiances, of which bands 2 p and 2 p + 1 are the real and the imaginary part.

/// Gives both bands of each pair the sum of both.
inline void add_pairs(std::vector<double>& values) {
  for (std::size_t b = 0; b + 1 < values.size(); b += 2)
    values[b] = values[b + 1] = values[b] + values[b + 1];
}

/// Gives both bands of each pair the larger number.
inline void take_larger_of_pairs(std::vector<double>& values) {
  for (std::size_t b = 0; b + 1 < values.size(); b += 2)
    values[b] = values[b + 1] = std::max(values[b], values[b + 1]);
}

}  // namespace etendue
