// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <variant>

#include "solver/materials/phase/phase_models.h"
#include "solver/materials/phase/phase_series.h"
#include "solver/materials/phase/phase_table.h"

namespace etendue {

/// What a mixture can hold.
using PhasePart = std::variant<PhaseIsotropic, PhaseRayleigh, PhaseHenyeyGreenstein, PhaseCornetteShanks,
                               PhaseLegendre, PhaseTable>;

}  // namespace etendue
