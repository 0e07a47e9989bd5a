// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solver/problem/problem.h"

namespace etendue {

/// Absorption and scattering where formulas of the place give them, linear in each cell: their L2 projection,
/// with the cell's mean that the sweep sees, and flatter where it would be negative at a corner. Numbers are
/// left out, and so are kernels by formula and absorption by direction, whose means alone are known.
class LinearCoefficients {
 public:
  explicit LinearCoefficients(const Problem& problem);

  bool empty() const { return slopes_.empty(); }
  bool varies(CellIndex cell) const { return !row_.empty() && row_[cell.at()] >= 0; }

  /// By how much a coefficient differs at a point of a varying cell from its mean there [1/length].
  double absorption(CellIndex cell, std::size_t band, const Vec3& point) const {
    const Slopes& slopes = at(cell, band);
    return slopes.absorption.dot(point - slopes.centroid);
  }
  double scattering(CellIndex cell, std::size_t band, const Vec3& point) const {
    const Slopes& slopes = at(cell, band);
    return slopes.scattering.dot(point - slopes.centroid);
  }

 private:
  struct Slopes {
    Vec3 absorption = Vec3::Zero(), scattering = Vec3::Zero();
    Vec3 centroid = Vec3::Zero();
  };
  const Slopes& at(CellIndex cell, std::size_t band) const {
    return slopes_[static_cast<std::size_t>(row_[cell.at()]) * bands_ + band];
  }

  std::size_t bands_;
  std::vector<std::int32_t> row_;  ///< [cell], -1 where nothing varies
  std::vector<Slopes> slopes_;     ///< [row][band]
};

}  // namespace etendue
