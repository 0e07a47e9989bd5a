// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "solver/heat/temperature_iteration.h"
#include "solver/solution/solution.h"
#include "solver/stepping/step_plan.h"

namespace etendue {

/// A step in time that was taken.
struct HeatStep {
  double begin = 0, end = 0;  ///< [s]
  double error = 0;           ///< what StepPlan::tolerance bounds
  double missing = 0;         ///< heat that was gained and is not stored [J]: the iteration leaves it
  double stored = 0;          ///< heat that all media and walls have gained since t = 0 [J]
  int sweeps = 0;             ///< of all its solutions
  double residual = 0;        ///< the largest of them
  bool converged = true;      ///< all of them
  Solution& solution;         ///< at its end
};

/// Returns false where no more steps are wanted.
using HeatStepReader = std::function<bool(const HeatStep&)>;

/// Solves the transport equation with the temperatures of TemperatureIteration, which it improves.
using LightSolver = std::function<Solution()>;

/// Steps of temperatures from those at t = 0 on, (T7) of docs/theory/heat.md: heat is stored, and light is at
/// each time that of the temperatures then. Errors are by how much a step of first order would change the
/// temperatures, as a root mean square over what holds heat, relative to the highest. Steps that adapt become
/// shorter where the iteration for their temperatures does not converge. Throws what
/// take_all_steps() and the solver do, and SolveStopped where a solution was interrupted.
void march_heat(TemperatureIteration& temperatures, const LightSolver& solver, const StepPlan& plan,
                const HeatStepReader& reader);

}  // namespace etendue
