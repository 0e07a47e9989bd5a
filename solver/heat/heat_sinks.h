// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/heat/temperature_space.h"
#include "solver/problem/problem.h"

namespace etendue {

/// Throws InputError where heat has no way out of a volume in which a temperature follows: no wall of it
/// absorbs at a temperature that is given, none is cooled by convection, and no medium of it absorbs at a
/// temperature that is given. Opaque sheets part volumes.
void check_heat_sinks(const Problem& problem, const HeatProblem& heat, const TemperatureSpace& space);

}  // namespace etendue
