// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdlib>

#include "app/case/lamps/light_table.h"

namespace etendue::test {

inline bool is_rising(const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]) || (i > 0 && !(values[i] > values[i - 1]))) return false;
  return true;
}

/// Ends the program where a table is not what LightTable says.
inline void check(const LightTable& table) {
  const std::size_t planes = table.plane.empty() ? 1 : table.plane.size();
  if (table.angle.empty() || table.intensity.size() != planes * table.angle.size()) std::abort();
  if (!is_rising(table.angle) || !is_rising(table.plane)) std::abort();
  for (const double intensity : table.intensity)
    if (!std::isfinite(intensity) || intensity < 0) std::abort();
}

}  // namespace etendue::test
