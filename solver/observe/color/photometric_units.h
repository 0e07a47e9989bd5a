// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

namespace etendue {

enum class PhotometricDimension {
  illuminance,
  luminous_exitance,
  luminance,
  luminous_flux,
  luminous_intensity,
  luminous_energy
};

/// A unit of photometry, SI or older.
struct PhotometricUnit {
  std::string name;    ///< "footcandle"
  std::string symbol;  ///< "fc"
  PhotometricDimension dimension;
  double in_si;  ///< what one of it is in lx, lm/m^2, cd/m^2, lm, cd or lm s
};

/// All that are known.
std::span<const PhotometricUnit> photometric_units();

/// Names and symbols of the units of a dimension, those of the SI first.
std::vector<std::string> photometric_unit_names(PhotometricDimension dimension);

/// By name or symbol; null where there is none.
const PhotometricUnit* find_photometric_unit(const std::string& name);

}  // namespace etendue
