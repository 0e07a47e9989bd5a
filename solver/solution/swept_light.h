// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "solver/angular/sets/direction_set.h"
#include "solver/solution/angular_input.h"
#include "solver/solution/solution.h"

namespace etendue {

/// What was solved on a set of directions, before light that was found along rays is added and means over
/// rotated sets are taken.
struct SweptLight {
  const DirectionSet& directions;
  const Solution& solution;
  const AngularInput* input = nullptr;  ///< of the sweeps; null without one
  /// First-collided light where it has its own set of directions, with its input as the only source; null
  /// where `solution` holds it. The fluence and moments of `solution` include it, its radiance and flux do
  /// not.
  const SweptLight* first_collided = nullptr;
};

/// Looks at what was found on each set of directions that a run sweeps.
using SetReader = std::function<void(const SweptLight&)>;

}  // namespace etendue
