// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "solver/uncollided/sources/extended_source.h"

namespace etendue {

/// What light with an extent meets on its way to a place.
struct WayLoss {
  double visible = 1;        ///< part of the fluence that nothing opaque stands before
  double extinction = 0;     ///< of the even matter that takes as much of the visible part [1/length]
  Vec3 turn = Vec3::Zero();  ///< by how much the mean direction, net flux over fluence, differs from there
  double way = 0;            ///< mean length of the visible part [length]
};

/// What a place sees of a light: all, a part, nothing; it lies behind; or that depends on the side of a
/// sheet.
enum class Seen : char { all, part, nothing, behind, by_side };

/// Looks at a light through what there is: the loss [band]. `beams` is room to work in.
Seen look(const ExtendedSource& source, const PointInCell& here, LightDetail detail, LightBeams& beams,
          std::span<WayLoss> loss);

}  // namespace etendue
