// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/angular/sets/direction_set.h"

namespace etendue {

/// A cone about an axis, and how often quadrilaterals that it meets are split in four.
struct ConeRefinement {
  Vec3 direction = Vec3::UnitZ();  ///< of any length but zero
  double angle = 0;                ///< between axis and surface [degrees]
  int levels = 1;
};

/// LDFE-SQ with finer quadrilaterals in a cone and in its opposite, since every direction's opposite is in a
/// set. Quadrilaterals stay within their octant: half ranges along the axes stay exact. Weights
/// are then changed by a small factor that makes the second moments exact, which uneven splitting upsets.
/// Throws std::length_error where it would have more than 100,000 directions.
DirectionSet directions_ldfe_sq(int order, const ConeRefinement& refinement);

}  // namespace etendue
