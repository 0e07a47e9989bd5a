// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/case/keys/section.h"
#include "app/case/read/materials/read_temperature.h"

namespace etendue {

/// Reads `heat_source` and `conductivity` of a medium whose other coefficients are read, from which its
/// temperature follows: of one gray band without conduction the medium reradiates what it absorbs.
void read_heat_source(Section& section, const ThermalContext& context, MediumCase& medium);

/// Reads `heat_flux` and `convection` of a wall whose other values are read, from which its temperature
/// follows.
void read_wall_heat(Section& section, const ThermalContext& context, bool beside_conductors, WallCase& wall);

}  // namespace etendue
