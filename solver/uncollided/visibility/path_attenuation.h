// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "solver/uncollided/sources/extended_source.h"

namespace etendue {

/// Attenuation of the light of an extended source on its paths to a point.
struct PathAttenuation {
  double visible = 1;  ///< fraction of the fluence whose paths are not blocked
  double extinction =
      0;  ///< of the homogeneous medium with the same attenuation of the visible part [1/length]
  Vec3 deflection =
      Vec3::Zero();   ///< difference of the mean direction, net flux over fluence, from that medium
  double length = 0;  ///< mean path length of the visible part [length]
};

/// Visibility of a light from a point: all of it, a part, nothing; the point lies behind it; or the
/// visibility depends on the side of a sheet.
enum class Visibility : char { all, part, nothing, behind, depends_on_side };

/// Samples a light from a point through media and past obstacles: writes the attenuation [band]. `beams` is
/// scratch memory.
Visibility sample(const ExtendedSource& source, const PointInCell& here, LightDetail detail,
                  LightBeams& beams, std::span<PathAttenuation> attenuation);

}  // namespace etendue
