// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/angular/sets/direction_set.h"

namespace etendue {

/// A coarse, a usual and a fine set of each family.
inline std::vector<DirectionSet> sets_to_test() {
  return {directions_product(2),         directions_product(8),         directions_product(16),
          directions_triangular(2),      directions_triangular(8),      directions_triangular(16),
          directions_ldfe_sq(1),         directions_ldfe_sq(2),         directions_ldfe_sq(4),
          directions_double_gauss(2),    directions_double_gauss(4),    directions_double_gauss(8),
          directions_level_symmetric(2), directions_level_symmetric(8), directions_level_symmetric(16),
          directions_thurgood(1),        directions_thurgood(4),        directions_thurgood(8)};
}

inline std::string label(const DirectionSet& set) { return set.name() + " " + std::to_string(set.order()); }

}  // namespace etendue
