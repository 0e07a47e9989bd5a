// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/case/section.h"

namespace etendue {

/// Reads where the sun stands and what sky there is: the direction of a sun, or the distribution of a CIE
/// standard general sky or of a sky of Perez.
void read_daylight(Section& section, LightCase& light);

}  // namespace etendue
