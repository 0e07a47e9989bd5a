// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/time/steps_in_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "app/setup/memory.h"
#include "app/time/emission_courses.h"
#include "app/time/step_times.h"
#include "app/write/result/unit_labels.h"
#include "base/vector_sums.h"
#include "solver/time/time_steps.h"

namespace etendue {
namespace {

/// Ends of steps at which factors are looked at before the march.
constexpr double most_checked = 1e4;
/// Throws InputError where a factor is not finite, or below 0, at the end of an even step.
void check_factors(const EmissionCourses& courses, double until, double steps) {
  const double count = std::min(steps, most_checked);
  for (const Course& course : courses.courses)
    for (double k = 1; k <= count && !course.is_pulse; ++k) course.factor(until * k / count);
}

}  // namespace

RunMemory steps_memory(const TimeSetup& setup) {
  RunMemory memory;
  // Beside it are the steady solution, fluence, flux and state, and the fluence at frequencies, complex.
  const TimeCase& time = *setup.input.time;
  const std::size_t field = 4 * sizeof(double) * static_cast<std::size_t>(setup.problem.mesh().cell_count()) *
                            static_cast<std::size_t>(setup.problem.band_count());
  const std::size_t fields = 6 + setup.options.keep_ordinates.size() + static_cast<std::size_t>(time.frames) +
                             (time.modulation.empty() ? 0 : 2 * (time.modulation.size() + 1));
  const std::size_t besides = fields * field + memory_of_rays(setup, 1);
  const auto marching = [&](KrylovVectors vectors) {
    return estimate_march_memory(setup.problem, setup.sets.front(), setup.options, vectors) + besides;
  };
  memory.solving = marching(KrylovVectors::all);
  memory.expected = marching(KrylovVectors::typical);
  memory.matrices = matrix_memory_text(setup.problem, setup.sets.front());
  return memory;
}

std::string steps_plan_text(const TimeSetup& setup) {
  const TimeCase& time = *setup.input.time;
  if (setup.sets.size() > 1)
    throw InputError(
        fault_at(time.origin, "", "takes steps along one set of directions; leave directions.rotations out"));
  const EmissionCourses courses = emission_courses(setup.input, setup.problem);
  refuse_pulses_through_walls(setup.lights.remaining(), remaining_courses(setup.lights, courses));
  const double count = least_steps(time);
  check_factors(courses, *time.until, count);
  return fmt::format(
      "steps in time: {}{:.0f} of {:.4g} {}, to {:.4g} {}; the radiance of all directions is kept ({:.2g} "
      "GiB)\n",
      time.tolerance ? "at least " : "", count, *time.until / count, time.unit, *time.until, time.unit,
      static_cast<double>(steps_memory(setup).solving) / 1073741824.0);
}

void take_steps(const TimeSetup& setup, const TimeNumbers& numbers, const Solution& steady,
                const UncollidedInTime* uncollided, const std::function<bool()>& interrupted,
                const std::function<void(double)>& share, TimeResult& result) {
  const TimeCase& time = *setup.input.time;
  const EmissionCourses courses = emission_courses(setup.input, setup.problem);
  StepOptions steps{step_plan(time)};
  std::vector<double> swept = steady.fluence;
  if (uncollided != nullptr) add_to(swept, steady.lights.fluence, -1);
  steps.scale = rms_fluence(setup.problem, swept);
  steps.read = [&](const Problem& problem, const Solution& solution) {
    return numbers.values(problem, solution);
  };
  steps.read_uncollided = [&](const UncollidedValues& values) { return numbers.uncollided(values); };
  SolveOptions options = setup.options;
  options.meters = numbers.meters();
  options.stops = interrupted;
  const auto is_interrupted = [&] { return any_of(setup.options.ranks, interrupted()); };
  StepsInTime& taken = result.steps.emplace();
  taken.quantities = numbers.quantities();
  const UnitLabels units(setup.input.units, setup.input.angular_space);
  for (const std::string& band : setup.problem.bands().names)
    taken.quantities.push_back({"energy", "light", band, units.power + " " + time.unit});
  const auto observe = [&](const SweepProgress&) {
    return is_interrupted() ? SolveControl::stop : SolveControl::proceed;
  };
  const std::vector<double> frames = frame_times(time);
  const auto reader = [&](const TimeStep& step) {
    StepInTime row{step.end, step.error, step.imbalance, step.values, step.errors};
    row.values.insert(row.values.end(), step.energy.begin(), step.energy.end());
    row.errors.insert(row.errors.end(), step.energy_errors.begin(), step.energy_errors.end());
    taken.largest_energy = std::max(taken.largest_energy, *std::ranges::max_element(step.energy));
    taken.steps.push_back(std::move(row));
    taken.sweeps = std::max(taken.sweeps, step.sweeps);
    result.residual = std::max(result.residual, step.residual);
    result.converged = result.converged && step.converged;
    if (std::ranges::find(frames, step.end) != frames.end()) {
      taken.frames.push_back({step.end, step.solution.fluence});
      if (step.uncollided != nullptr) add_to(taken.frames.back().values, step.uncollided->field.fluence);
    }
    share(step.end / *time.until);
    return !is_interrupted();
  };
  try {
    march_in_time(setup.problem, setup.sets.front(), slowness_of(setup.input, setup.problem), courses, steps,
                  options, reader, observe, uncollided);
  } catch (const SolveStopped&) {
    result.interrupted = true;
  } catch (const std::domain_error&) {
    taken.fault =
        "time.tolerance asks for steps below a billionth of until; give a larger one, or even steps";
  } catch (const InputError& fault) {
    taken.fault = fault.what();
  }
  if (!taken.fault.empty()) result.converged = false;
  result.interrupted = is_interrupted() || result.interrupted;
  if (taken.steps.empty() && taken.fault.empty()) result.steps.reset();
}

}  // namespace etendue
