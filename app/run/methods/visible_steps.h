// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "app/run/methods/visible_solution.h"
#include "app/time/heat_steps.h"

namespace etendue {

/// take_heat_steps() that is shown. After the first step a signal ends the steps after the one that is taken;
/// where that takes more than half a second from then on, the results are those of the step before.
std::optional<Solution> step_visibly(UncollidedLight& uncollided, const VisibleSolving& solving,
                                     const HeatStepsSetup& setup, const DirectionSetObserver& reader,
                                     TimeResult& result);

}  // namespace etendue
