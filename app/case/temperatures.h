// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"

namespace etendue {

/// Whether a medium or wall of the case has a temperature, given or following from its heat.
bool has_temperatures(const Case& input);

/// Whether the temperature of a medium or wall follows and takes more than one solution of the transport
/// equation.
bool iterates_temperatures(const Case& input);

/// Returns whether temperatures are stepped in time: they change by the heat that media and walls store,
/// while light is at each time that of the temperatures then.
bool steps_temperatures(const Case& input);

}  // namespace etendue
