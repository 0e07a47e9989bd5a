// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "app/progress/stage_progress.h"
#include "app/setup/run_options.h"
#include "app/time/time_setup.h"
#include "app/write/result/time_result.h"
#include "solver/solution/solution.h"

namespace etendue {

/// What a person reads before light in time is solved for: how many rates and steps, and what is not read.
/// Throws InputError where the memory of this machine does not suffice.
std::string time_plan_text(const TimeSetup& setup);

/// Memory of the rates that are solved for side by side, or of steps.
RunMemory time_memory(const TimeSetup& setup);

/// Solves for all that [time] asks, which is there, beside the steady solution; `interrupted` ends it early.
TimeResult solve_in_time(const TimeSetup& setup, const Solution& steady, const StageDisplay& stages,
                         const std::function<bool()>& interrupted);

}  // namespace etendue
