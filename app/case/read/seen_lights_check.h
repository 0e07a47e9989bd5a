// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/case/keys/value_check.h"

namespace etendue {

/// Reports sensors that would miss a light: suns, skies and beams that are left to the directions
/// (`uncollided = false`) have no radiance along rays, by which sensors see. Walls that shine, and the cells
/// of lamps inside, are seen in any case, and the account of a region and the flux through its surface count
/// the directions themselves.
void check_sensors_see_lights(const Case& input, Faults& faults);

}  // namespace etendue
