// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "solver/angular/sets/direction_set.h"
#include "solver/solution/angular_input.h"
#include "solver/solution/solution.h"

namespace etendue {

/// Solution on one set of directions, without the uncollided light and before the mean over rotated sets.
struct DirectionSetSolution {
  const DirectionSet& directions;
  const Solution& solution;
  const AngularInput* input = nullptr;  ///< of the sweeps; null without one
  /// First-collided light where it has its own set of directions, with its input as the only source; null
  /// where `solution` holds it. The fluence and moments of `solution` include it, its radiance and flux do
  /// not.
  const DirectionSetSolution* first_collided = nullptr;
};

/// Receives the solution on each set of directions of a run.
using DirectionSetObserver = std::function<void(const DirectionSetSolution&)>;

}  // namespace etendue
