// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// Temperatures [K] of a region at the vertices and centroids of its cells, or of a wall at those of its
/// faces.
struct TemperatureRange {
  std::string place;  ///< the region or wall
  double lowest = 0;
  double highest = 0;
  double mean = 0;               ///< over the volume or area
  double fraction_in_bands = 1;  ///< of the power of a blackbody of the mean temperature
};

/// Of all regions and walls of the mesh that have a temperature, at t = 0 or always. Throws InputError with
/// the place where one is negative or not a number.
std::vector<TemperatureRange> temperature_ranges(const Case& input, const TetrahedralMesh& mesh);

/// Ratios of water vapour to carbon dioxide at the centroids of cells that hold gases.
struct MolarRatioRange {
  double lowest = 0, highest = 0;
  double beyond = 0;  ///< part of their volume where the gases are not known for the ratio
};

/// None where the ratio is a number of the whole case. Throws InputError with the place where it is no number
/// in a cell or face that needs it.
std::optional<MolarRatioRange> molar_ratio_range(const Case& input, const TetrahedralMesh& mesh);

}  // namespace etendue
