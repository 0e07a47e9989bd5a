// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "app/case/keys/section.h"
#include "base/vec3.h"

namespace etendue {

/// Where the sun stands over a case; up is z.
struct SunPlace {
  double altitude = 0;         ///< [degree]
  double azimuth = 0;          ///< [degree] clockwise from north
  Vec3 north = Vec3::UnitY();  ///< unit, level
  double eccentricity = 1;  ///< square of the mean over the present distance; 1 where the date is not known
  Vec3 to_sun = Vec3::UnitZ();  ///< unit
};

/// Reads `sun_position` of a light; empty where it is absent or faulty. A sun below the horizon is a fault.
std::optional<SunPlace> read_sun_position(Section& light);

}  // namespace etendue
