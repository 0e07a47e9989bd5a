// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/time/step_times.h"

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

constexpr double usual_steps = 100;

}  // namespace

double longest_step(const TimeCase& time) { return time.step.value_or(*time.until / usual_steps); }

double least_steps(const TimeCase& time) {
  const double frames = std::max(1, time.frames);
  return frames * std::ceil(*time.until / frames / longest_step(time) - alike_steps);
}

std::vector<double> frame_times(const TimeCase& time) {
  std::vector<double> times;
  for (int frame = 1; frame < time.frames; ++frame) times.push_back(*time.until * frame / time.frames);
  if (time.frames > 0) times.push_back(*time.until);
  return times;
}

StepPlan step_plan(const TimeCase& time) {
  StepPlan plan{time.method, *time.until, longest_step(time), time.tolerance.value_or(0), frame_times(time)};
  if (!plan.stops.empty()) plan.stops.pop_back();
  return plan;
}

}  // namespace etendue
