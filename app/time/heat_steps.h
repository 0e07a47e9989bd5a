// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "app/case/case.h"
#include "app/write/result/time_result.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/heat/temperature_iteration.h"
#include "solver/problem/problem.h"
#include "solver/solution/direction_set_solution.h"
#include "solver/solution/solution.h"
#include "solver/solution/solve_options.h"
#include "solver/uncollided/first_collision/solve_split.h"

namespace etendue {

/// A case whose temperatures change with time, and what it is solved with.
struct HeatStepsSetup {
  const Case& input;
  Problem& problem;  ///< is given the emission of the temperatures
  TemperatureIteration& temperatures;
  const DirectionSet& directions;
  const SolveOptions& options;
  const CellLocator& locator;
};

/// What steps tell while they are taken; each may be empty.
struct HeatStepsObserver {
  std::function<bool()> interrupted;  ///< whether they are to end after this one
  /// After each step: the part of the time, and its solution.
  std::function<void(double share, const Solution& solution)> reached;
};

/// What a person reads before the first step.
std::string heat_steps_text(const Case& input);

/// Bytes that the steps take beside a steady solution.
std::size_t heat_steps_memory(const Case& input, const Problem& problem, const SolveOptions& options);

/// Takes the steps, and hands the uncollided light over to the solution at the end, which comes back. What
/// was read at the end of each goes into the result; where a step fails, or the run is interrupted, the
/// solution is that of the step before. Empty: the run was interrupted within the first. Throws as solve()
/// does where the first fails.
std::optional<Solution> take_heat_steps(const HeatStepsSetup& setup, UncollidedLight& uncollided,
                                        const HeatStepsObserver& observer, const DirectionSetObserver& reader,
                                        TimeResult& result);

}  // namespace etendue
