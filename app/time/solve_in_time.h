// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "app/case/case.h"
#include "app/progress/stage_progress.h"
#include "app/setup/run_options.h"
#include "app/write/result/time_result.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/solution/solve_options.h"

namespace etendue {

/// A case and what its steady solution has been made with.
struct TimeSetup {
  const Case& input;
  const Problem& problem;
  const std::vector<DirectionSet>& sets;
  const SolveOptions& options;
  const CellLocator& locator;
  bool follows_rays = false;  ///< whether the steady solution has light along rays
};

/// What a person reads before light in time is solved for: how many rates, and what is not read. Throws
/// InputError where the memory of this machine does not suffice.
std::string time_plan_text(const TimeSetup& setup);

/// Memory of the rates that are solved for side by side.
RunMemory time_memory(const TimeSetup& setup);

/// Solves for all that [time] asks, which is there; `interrupted` ends it early.
TimeResult solve_in_time(const TimeSetup& setup, const StageDisplay& stages,
                         const std::function<bool()>& interrupted);

}  // namespace etendue
