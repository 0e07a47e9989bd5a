// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "app/case/keys/section.h"
#include "app/case/read/materials/read_temperature.h"

namespace etendue {

/// Reads `gas_pressure` of a medium whose absorption and temperature are read, and adds what the gray gases
/// absorb.
void read_gas_pressure(Section& section, const ThermalContext& context, MediumCase& medium);

}  // namespace etendue
