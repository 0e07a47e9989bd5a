// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/write/result/run_result.h"

namespace etendue {

/// Heat that one wall or region exchanges: by radiation, all bands together, by conduction and convection.
struct HeatRow {
  bool is_wall = false;
  std::string name;
  double extent = 0;       ///< area of a wall [m^2], volume of a region [m^3]
  double emitted = 0;      ///< without what is reflected [W]
  double absorbed = 0;     ///< [W]
  double net = 0;          ///< into a wall: absorbed - emitted; out of a region: emitted - absorbed [W]
  double error = 0;        ///< standard error of `net` by photons [W]
  double conducted = 0;    ///< into a wall [W]; 0 where no medium beside it conducts
  double convected = 0;    ///< what convection carries away from a wall [W]
  double temperature = 0;  ///< mean over the area or volume [K]; 0 where the case gives none

  /// Radiative heat flux into the wall [W/m^2], or divergence of the heat flux in the region [W/m^3].
  double density() const { return extent > 0 ? net / extent : 0; }
};

/// Walls, then regions, in the order of the mesh.
std::vector<HeatRow> heat_rows(const RunResult& result);

}  // namespace etendue
