// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/materials/phase/phase_function.h"

namespace etendue {

/// Angle [rad] at which a phase function has fallen to half of its value at deflection 0, pi if it does not.
double half_width(const PhaseFunction& phase);

}  // namespace etendue
