// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace etendue {

/// The entries of some bands, in their order, of [row][band]; `count` bands in all.
template <class Value>
std::vector<Value> select_bands(std::span<const Value> values, std::size_t count,
                                std::span<const int> bands) {
  std::vector<Value> result;
  result.reserve(values.size() / count * bands.size());
  for (std::size_t row = 0; row < values.size(); row += count)
    for (const int band : bands) result.push_back(values[row + static_cast<std::size_t>(band)]);
  return result;
}

}  // namespace etendue
