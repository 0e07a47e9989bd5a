// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "app/case/case.h"
#include "app/setup/exact_setup.h"
#include "app/setup/run_directions.h"
#include "app/setup/run_options.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/heat/heat_solution.h"
#include "solver/heat/temperature_iteration.h"
#include "solver/problem/problem.h"
#include "solver/solution/solution.h"
#include "solver/solution/solve_options.h"
#include "solver/transport/solve/resolution.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// All that a run by discrete ordinates needs before its first sweep. Throws InputError with the first of
/// what the run refuses: views, lights, directions, sensors, probes.
struct OrdinatesSetup {
  LightSetup lights;
  RunDirections directions;
  CellLocator locator;
  std::optional<ExactSetup> exact;
  std::optional<HeatProblem> heat;  ///< of a case whose temperatures follow by iteration
  std::unique_ptr<TemperatureIteration> temperatures;
  SolveOptions options;

  /// The arguments must outlive it.
  OrdinatesSetup(const Case& input, const Problem& problem);
  OrdinatesSetup(const OrdinatesSetup&) = delete;  // the options point into it
  OrdinatesSetup& operator=(const OrdinatesSetup&) = delete;

  const DirectionSet& set() const { return directions.sets.front(); }
  /// How finely cells and the finest directions resolve the problem; cells count as lumped where the options
  /// let the program choose.
  Resolution resolution(const Problem& problem) const;
  /// Gives the problem the emission of the temperatures that a solution has found.
  void set_emission(Problem& problem) const;
  /// Temperatures that a solution has found; null: none follow.
  std::optional<HeatSolution> heat_solution() const;
  RunMemory memory() const { return memory_of(lights, directions, options); }
};

}  // namespace etendue
