// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vec3.h"

namespace etendue {

/// Directions and their solid angles [sr], not yet a set.
struct WeightedDirections {
  std::vector<Vec3> directions;
  std::vector<double> weights;
};

/// The directions of the octant x, y, z > 0 and their seven mirror images, equal to the last bit.
WeightedDirections mirror_octant(const WeightedDirections& octant);

}  // namespace etendue
