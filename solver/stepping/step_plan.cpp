// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/stepping/step_plan.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace etendue {
namespace {

constexpr double safety = 0.9;
constexpr double largest_growth = 2;
constexpr double least_growth = 1.4;  ///< below it new coefficients do not pay
constexpr double strongest_cut = 0.1;
constexpr double weakest_cut = 0.7;
constexpr double shortest_part = 1e-9;  ///< of all the time

void check(const StepPlan& plan) {
  if (!(plan.until > 0) || !(plan.step > 0) || plan.tolerance < 0 ||
      (plan.tolerance > 0 && plan.method == StepMethod::bdf2))
    throw std::invalid_argument("steps that lead nowhere");
}

/// Length to be tried after a step of length `taken`, where `step` was the longest allowed so far.
double next_step(const StepPlan& plan, double taken, double step, double error) {
  const double growth = error > 0 ? safety * std::sqrt(plan.tolerance / error) : largest_growth;
  if (!plan.accepts(error)) {
    const double next = taken * std::clamp(growth, strongest_cut, weakest_cut);
    if (next < shortest_part * plan.until)
      throw std::domain_error("steps in time become too short for their tolerance");
    return next;
  }
  if (growth < 1) return taken * growth;
  if (growth < least_growth) return step;
  return std::min(plan.step, std::max(step, taken * std::min(growth, largest_growth)));
}

}  // namespace

void take_all_steps(const StepPlan& plan, const StepTaker& take) {
  check(plan);
  std::vector<double> stops = plan.stops;
  stops.push_back(plan.until);
  double step = plan.step, t = 0, last = 0;
  for (const double stop : stops)
    while (t < stop) {
      const double left = std::ceil((stop - t) / step - alike_steps);
      const double wanted = (stop - t) / std::max(1.0, left);
      const double taken = std::abs(wanted - last) < alike_steps * wanted ? last : wanted;
      const double end = left <= 1 ? stop : t + taken;
      const std::optional<double> error = take(t, taken, end);
      if (!error) return;
      if (plan.accepts(*error)) {
        t = end;
        last = taken;
      }
      if (plan.tolerance > 0) step = next_step(plan, taken, step, *error);
    }
}

}  // namespace etendue
