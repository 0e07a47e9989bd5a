// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/time/step_times.h"

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

constexpr double usual_steps = 100;
/// Tolerance of temperatures where neither step nor tolerance is given: temperatures that are far from
/// balance change within a hundredth of `until`.
constexpr double usual_tolerance = 1e-3;

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

StepPlan heat_step_plan(const Case& input) {
  StepPlan plan = step_plan(*input.time);
  if (!input.time->step && !input.time->tolerance && plan.method == StepMethod::sdirk2)
    plan.tolerance = usual_tolerance;
  const auto add = [&](const std::optional<InTime>& in_time) {
    if (!in_time) return;
    for (const double t : in_time->times)
      if (t > 0 && t < plan.until) plan.stops.push_back(t);
  };
  for (const auto& [name, medium] : input.media) add(medium.in_time);
  for (const auto& [name, wall] : input.walls) add(wall.in_time);
  std::ranges::sort(plan.stops);
  plan.stops.erase(std::unique(plan.stops.begin(), plan.stops.end()), plan.stops.end());
  return plan;
}

StepPlan step_plan(const TimeCase& time) {
  StepPlan plan{time.method, *time.until, longest_step(time), time.tolerance.value_or(0), frame_times(time)};
  if (!plan.stops.empty()) plan.stops.pop_back();
  return plan;
}

}  // namespace etendue
