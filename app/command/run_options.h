// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "app/command/run_directions.h"
#include "solver/angle/direction_set.h"
#include "solver/lights/light_setup.h"
#include "solver/ordinates/solve_options.h"

namespace etendue {

/// The solver's options as the case has them, with all that a run adds.
SolveOptions run_options(const Case& input, const DirectionSet& directions,
                         std::vector<IrradianceMeter> meters);

/// Memory that a run needs to solve its case.
struct RunMemory {
  std::size_t solving = 0;  ///< [bytes]
  std::string matrices;     ///< matrix_memory_text()
};

RunMemory memory_of(const LightSetup& lights, const RunDirections& directions, const SolveOptions& options);

}  // namespace etendue
