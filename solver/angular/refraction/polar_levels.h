// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "solver/angular/sets/direction_set.h"

namespace etendue {

/// All directions of a set that make the same angle with an axis, on either side.
struct PolarLevel {
  double cosine;  ///< to the axis, at least 0
  double weight;  ///< of its directions together [sr]
};

/// The levels of a set about an axis, from the axis to the equator.
class PolarLevels {
 public:
  PolarLevels(const DirectionSet& directions, const Vec3& axis);

  const std::vector<PolarLevel>& levels() const { return levels_; }
  std::size_t of_ordinate(std::size_t ordinate) const { return level_of_[ordinate]; }

 private:
  std::vector<PolarLevel> levels_;
  std::vector<std::size_t> level_of_;  ///< [ordinate]
};

}  // namespace etendue
