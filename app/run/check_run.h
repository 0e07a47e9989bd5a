// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "app/setup/run_options.h"
#include "solver/problem/problem.h"
#include "solver/transport/solve/resolution.h"

namespace etendue {

/// What is known of a run before its first sweep.
struct CheckedRun {
  /// On this mesh; empty by radiosity, which takes its memory for patches that it cuts as it goes.
  std::optional<RunMemory> memory;
  std::optional<Resolution> resolution;  ///< by ordinates
  std::vector<std::string> plans;        ///< plan_texts(), by ordinates
};

/// Throws InputError with the first of what a run of the case would refuse before its first sweep: names and
/// places, lights, directions, sensors, cameras, and what the case's method does not know. On small meshes
/// one sweep is made, which finds what only the solver refuses.
CheckedRun check_run(const Case& input, const Problem& problem);

/// The case with the coarsest cells that its geometry has: as good as any for check_run(), and soon meshed.
Case with_coarsest_cells(Case input);

}  // namespace etendue
