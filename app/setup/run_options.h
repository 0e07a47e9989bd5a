// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "app/setup/run_directions.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/solution/solve_options.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// The solver's options as the case has them, with all that a run adds.
SolveOptions run_options(const Case& input, const DirectionSet& directions,
                         std::vector<IrradianceMeter> meters);

/// Memory that a run needs to solve its case.
struct RunMemory {
  std::size_t solving = 0;    ///< [bytes], at most
  std::size_t expected = 0;   ///< [bytes]
  std::string matrices = {};  ///< matrix_memory_text()
};

/// Of two stages, one after the other.
RunMemory larger_of(RunMemory a, RunMemory b);

/// Memory of a run on this very mesh as a line. Throws InputError as the run does where this machine has not
/// so much.
std::string memory_text(const RunMemory& memory, const Problem& problem);

RunMemory memory_of(const LightSetup& lights, const RunDirections& directions, const SolveOptions& options);

}  // namespace etendue
