// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "app/case/case.h"
#include "solver/stepping/step_plan.h"

namespace etendue {

/// Length of the steps of a case with `until`, at most [time].
double longest_step(const TimeCase& time);

/// How many steps it takes, at least.
double least_steps(const TimeCase& time);

/// Times of which fields are written.
std::vector<double> frame_times(const TimeCase& time);

/// Its steps, which end at these times too.
StepPlan step_plan(const TimeCase& time);

/// Steps of temperatures, which also end where tables of heat sources and fluxes have lines, and adapt where
/// the case says nothing of steps.
StepPlan heat_step_plan(const Case& input);

}  // namespace etendue
