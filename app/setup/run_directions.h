// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/case/case.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// The sets of a run, one for each rotation; of light that has collided once as many or none.
struct RunDirections {
  std::vector<DirectionSet> sets;
  std::vector<DirectionSet> first_collided;
};

RunDirections run_directions(const Case& input, const Problem& problem, const LightSetup& lights);

/// Of light that has collided once, where that is swept on a set of its own.
const DirectionSet& finest(const RunDirections& directions);

/// For people; with the reason of a set that the case did not ask for.
std::string directions_line(const RunDirections& directions, const Case& input);

/// Says which refracting walls have too few directions within their critical angle for weights of their own.
std::string refraction_caution(const RunDirections& directions, const Problem& problem);

}  // namespace etendue
