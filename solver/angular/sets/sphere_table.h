// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// A smooth function of the direction from its values every few degrees, cubic in polar angle and azimuth.
class SphereTable {
 public:
  /// `rows` intervals from pole to pole, twice as many about the axis; a multiple of 4, so that coordinate
  /// planes, where formulas have kinks, are lines of the table.
  SphereTable(int rows, const std::function<double(const Vec3&)>& function);

  double at(const Vec3& direction) const;

 private:
  /// Rows beyond a pole are those on its other side.
  double node(int row, int column) const;

  int rows_;
  std::vector<double> values_;  ///< [row 0 … rows][column]
};

}  // namespace etendue
