// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "solver/uncollided/lights/light_setup.h"
#include "solver/uncollided/projection/uncollided_field.h"

namespace etendue {

/// Where uncollided light scatters for the first time.
struct FirstCollisions {
  std::vector<double> scattered;  ///< [cell][4][band] all that scatters [power/length^3]; empty: nothing does
  CollisionField collisions;      ///< what scatters by direction, and from where it comes
};

/// Takes the first collisions out of a field.
FirstCollisions first_collisions_of(const Problem& problem, UncollidedField field);

/// Follows the lights to their first collisions. Where there are no lights or nothing scatters, nothing is
/// followed. An observer that stops it leaves them incomplete.
std::shared_ptr<const FirstCollisions> find_first_collisions(const LightSetup& lights, int threads,
                                                             const StageObserver& observer = {});

}  // namespace etendue
