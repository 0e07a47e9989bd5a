// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "app/time/time_numbers.h"
#include "app/time/time_setup.h"
#include "app/write/result/time_result.h"
#include "solver/solution/solution.h"

namespace etendue {

/// What a person reads before the first step. Throws InputError where steps are not for this case.
std::string steps_plan_text(const TimeSetup& setup);

/// Memory that steps take, with all that is kept of them, and times of flight.
RunMemory steps_memory(const TimeSetup& setup);

/// Takes the steps of a case with `until`, and adds them to the result; `steady` is its steady solution, and
/// `uncollided` what is known along rays, or null.
/// `share` is called with the part of the time that is marched through.
void take_steps(const TimeSetup& setup, const TimeNumbers& numbers, const Solution& steady,
                const UncollidedInTime* uncollided, const std::function<bool()>& interrupted,
                const std::function<void(double)>& share, TimeResult& result);

}  // namespace etendue
