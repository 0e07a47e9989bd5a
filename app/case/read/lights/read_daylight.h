// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "app/case/case.h"
#include "app/case/keys/section.h"

namespace etendue {

/// Reads where the sun stands and what sky there is: the direction of a sun, or the distribution of a CIE
/// standard general sky or of a sky of Perez. Returns the illuminance of a level plane [lx] that a sky of
/// Perez has by its luminous efficacy; empty of other skies and of the sun.
std::optional<double> read_daylight(Section& section, LightCase& light);

}  // namespace etendue
