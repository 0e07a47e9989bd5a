// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "app/case/case.h"
#include "app/command/exact_setup.h"
#include "app/command/run_directions.h"
#include "app/command/run_options.h"
#include "mesh/tetrahedra/cell_locator.h"
#include "solver/lights/light_setup.h"
#include "solver/measure/resolution.h"
#include "solver/ordinates/solve.h"

namespace etendue {

/// All that a run by discrete ordinates needs before its first sweep. Throws InputError with the first of
/// what the run refuses: views, lights, directions, sensors, probes.
struct OrdinatesSetup {
  LightSetup lights;
  RunDirections directions;
  CellLocator locator;
  std::optional<ExactSetup> exact;
  SolveOptions options;

  /// The arguments must outlive it.
  OrdinatesSetup(const Case& input, const Problem& problem);
  OrdinatesSetup(const OrdinatesSetup&) = delete;  // the options point into it
  OrdinatesSetup& operator=(const OrdinatesSetup&) = delete;

  const DirectionSet& set() const { return directions.sets.front(); }
  /// How finely cells and the finest directions resolve the problem; cells count as lumped where the options
  /// let the program choose.
  Resolution resolution(const Problem& problem) const;
  RunMemory memory() const { return memory_of(lights, directions, options); }
};

}  // namespace etendue
