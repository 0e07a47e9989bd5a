// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/problem/problem.h"

namespace etendue {

/// Takes away all that a medium emits.
inline void darken(Medium& medium) {
  medium.emission.assign(medium.emission.size(), Coefficient(0.0));
  medium.blackbody.clear();
  medium.emission_by_direction.clear();
}

/// Takes away all that a wall emits.
inline void darken(Wall& wall) {
  wall.radiance.assign(wall.radiance.size(), 0);
  wall.radiance_by_direction.clear();
}

}  // namespace etendue
