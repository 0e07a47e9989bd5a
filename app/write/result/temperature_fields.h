// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/write/result/run_result.h"
#include "mesh/tetrahedra/search/cell_locator.h"

namespace etendue {

/// [cell] temperature at the centroid, given or from the heat balance [K]; 0 where the case gives none.
std::vector<double> cell_temperatures(const RunResult& result);

/// Temperature of a medium by iteration at a place in a cell [K].
double iterated_temperature(const HeatSolution& heat, const CellPoint& place);

/// Sets the temperature of the medium at each probe; where media meet that of one of them that has a
/// temperature.
void set_probe_temperatures(const CellLocator& locator, RunResult& result);

/// Temperature of one wall [K], given by the case or following.
class WallTemperature {
 public:
  WallTemperature(const RunResult& result, int wall);
  /// At a point with this irradiance [W/m^2], a corner [boundary face][3] where it follows by iteration; 0
  /// where the case gives none.
  double at(const Vec3& point, double irradiance, std::size_t corner) const;

 private:
  const Bands& bands_;
  std::optional<Coefficient> given_;
  double emissivity_ = 0;             ///< of a wall with a heat flux, else 0
  double heat_flux_ = 0;              ///< [W/m^2]
  std::span<const double> iterated_;  ///< [boundary face][3] [K]; empty: it follows otherwise, or is given
};

/// [wall]
std::vector<WallTemperature> wall_temperatures(const RunResult& result);

/// [boundary face][3] at the vertices [K]; 0 where the case gives none.
std::vector<double> vertex_temperatures_of_walls(const RunResult& result);

}  // namespace etendue
