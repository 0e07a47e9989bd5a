// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "app/write/result/run_result.h"

namespace etendue {

/// [cell] temperature at the centroid, given or from the heat balance [K]; 0 where the case gives none.
std::vector<double> cell_temperatures(const RunResult& result);

/// Temperature of one wall [K], from what the case gives or from what arrives.
class WallTemperature {
 public:
  WallTemperature(const RunResult& result, int wall);
  /// Whether the case gives the wall one.
  bool known() const { return given_.has_value() || emissivity_ > 0; }
  /// At a point where this much arrives [W/m^2].
  double at(const Vec3& point, double irradiance) const;

 private:
  std::optional<Coefficient> given_;
  double emissivity_ = 0;  ///< of a wall with a heat flux, else 0
  double heat_flux_ = 0;   ///< [W/m^2]
};

}  // namespace etendue
