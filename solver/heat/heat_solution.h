// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

namespace etendue {

/// Temperatures that follow from the heat of media.
struct HeatSolution {
  std::vector<double>
      temperature;  ///< [cell][4] at the vertices [K]; 0 where it does not follow or T^4 is below zero
  std::vector<double> conducted;  ///< [wall] heat into it [W]
  /// Thickness of the cells at walls that hold a temperature, over that of the layer in which conduction
  /// gives way to radiation, sqrt(k/w): the largest.
  double cells_per_layer = 0;
};

}  // namespace etendue
