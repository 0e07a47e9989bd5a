// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/materials/phase/phase_function.h"

namespace etendue {

/// A mixture of isotropic scattering, `share` of the coefficient, and this phase function. Throws
/// std::invalid_argument of one of the plane.
PhaseFunction with_isotropic_part(const PhaseFunction& phase, double share);

}  // namespace etendue
