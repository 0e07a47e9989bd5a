// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/sets/octant.h"

namespace etendue {

WeightedDirections mirror_octant(const WeightedDirections& octant) {
  WeightedDirections all;
  for (int signs = 0; signs < 8; ++signs) {
    const Vec3 sign(signs & 1 ? -1 : 1, signs & 2 ? -1 : 1, signs & 4 ? -1 : 1);
    for (const Vec3& direction : octant.directions) all.directions.push_back(direction.cwiseProduct(sign));
    all.weights.insert(all.weights.end(), octant.weights.begin(), octant.weights.end());
  }
  return all;
}

}  // namespace etendue
