// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "app/case/case.h"
#include "app/case/keys/section.h"
#include "solver/materials/surfaces/glazing.h"
#include "solver/problem/bands.h"

namespace etendue {

/// The glazing [band] of a table `walls.NAME.glazing`; empty where it is faulty, which is reported.
std::vector<Glazing> read_glazing(Section section, const Bands& bands);

/// Refuses a glazed wall that shines, mirrors or refracts in other ways.
void check_glazed_wall(Section& section, const WallCase& wall);

}  // namespace etendue
