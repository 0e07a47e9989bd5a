// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

namespace etendue {

/// Temperatures that follow from the heat of media and walls.
struct HeatSolution {
  std::vector<double>
      temperature;  ///< [cell][4] at the vertices [K]; 0 where it does not follow or T^4 is below zero
  std::vector<double>
      wall_temperature;           ///< [boundary face][3] at the vertices [K]; 0 where it does not follow
  std::vector<double> conducted;  ///< [wall] heat into it from media [W]
  std::vector<double> convected;  ///< [wall] heat that convection carries away from it [W]
  /// Thickness of the cells at walls that have a temperature, over that of the layer in which conduction
  /// gives way to radiation, sqrt(k/w): the largest.
  double cells_per_layer = 0;
};

}  // namespace etendue
