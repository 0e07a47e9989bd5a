// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/time/heat_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "app/time/heat_numbers.h"
#include "app/time/step_times.h"
#include "base/errors.h"
#include "solver/heat/heat_march.h"
#include "solver/uncollided/first_collision/repeated_solver.h"

namespace etendue {
namespace {

void add(SolveSeconds& sum, const SolveSeconds& seconds) {
  sum.orders = std::max(sum.orders, seconds.orders);  // made once
  sum.low_order_setup = std::max(sum.low_order_setup, seconds.low_order_setup);
  sum.sweep += seconds.sweep;
  sum.low_order += seconds.low_order;
  sum.lights += seconds.lights;
  sum.setup += seconds.setup;
}

/// The steps of one run.
class HeatSteps {
 public:
  HeatSteps(const HeatStepsSetup& setup, const HeatStepsObserver& observer, TimeResult& result)
      : setup_(setup),
        observer_(observer),
        result_(result),
        numbers_(setup.input, setup.problem, setup.locator) {}

  void take(RepeatedSolver& solver) {
    StepsInTime& taken = result_.steps.emplace();
    taken.quantities = numbers_.quantities();
    taken.of = "temperature";
    const auto light = [&] {
      Solution solution = solver.solve();
      add(seconds_, solution.seconds);
      return solution;
    };
    try {
      march_heat(setup_.temperatures, light, step_plan(*setup_.input.time),
                 [&](const HeatStep& step) { return read(step); });
    } catch (const SolveStopped&) {
      result_.interrupted = true;
    } catch (const std::domain_error&) {
      end_with("time.tolerance asks for steps below a billionth of until; give a larger one, or even steps");
    } catch (const InputError& fault) {
      if (!last_) throw;
      end_with(fault.what());
    }
  }

  /// At the end of the last whole step.
  std::optional<Solution> solution() {
    if (!last_) return std::nullopt;
    setup_.temperatures.start_from(last_->state.following);
    setup_.problem.set_following(setup_.temperatures.sources());
    last_->seconds = seconds_;
    last_->interrupted = last_->interrupted || result_.interrupted;
    return std::move(last_);
  }

 private:
  void end_with(const std::string& fault) {
    result_.steps->fault = fault;
    result_.converged = false;
  }

  bool read(const HeatStep& step) {
    StepsInTime& taken = *result_.steps;
    setup_.problem.set_following(setup_.temperatures.sources());
    const HeatSolution heat = setup_.temperatures.solution();
    taken.steps.push_back(
        {step.end, step.error, step.missing, numbers_.values(step.solution, heat, step.stored), {}});
    largest_change_ = std::max(largest_change_, std::abs(step.stored - std::exchange(stored_, step.stored)));
    taken.largest_energy = std::max({taken.largest_energy, std::abs(step.stored), largest_change_});
    taken.sweeps = std::max(taken.sweeps, step.sweeps);
    result_.residual = std::max(result_.residual, step.residual);
    result_.converged = result_.converged && step.converged;
    const std::vector<double> frames = frame_times(*setup_.input.time);
    if (std::ranges::find(frames, step.end) != frames.end())
      taken.frames.push_back({step.end, heat.temperature});
    last_ = std::move(step.solution);
    if (observer_.reached) observer_.reached(step.end / *setup_.input.time->until);
    const bool is_interrupted = observer_.interrupted && observer_.interrupted();
    result_.interrupted = result_.interrupted || (is_interrupted && step.end < *setup_.input.time->until);
    return !is_interrupted;
  }

  const HeatStepsSetup& setup_;
  const HeatStepsObserver& observer_;
  TimeResult& result_;
  HeatNumbers numbers_;
  std::optional<Solution> last_;
  SolveSeconds seconds_;
  double stored_ = 0, largest_change_ = 0;
};

}  // namespace

std::string heat_steps_text(const Case& input) {
  const TimeCase& time = *input.time;
  const double count = least_steps(time);
  return fmt::format("temperatures in time: {}{:.0f} steps of {:.4g} s, to {:.4g} s\n",
                     time.tolerance ? "at least " : "", count, *time.until / count, *time.until);
}

std::optional<Solution> take_heat_steps(const HeatStepsSetup& setup, UncollidedLight& uncollided,
                                        const HeatStepsObserver& observer, const DirectionSetObserver& reader,
                                        TimeResult& result) {
  HeatSteps steps(setup, observer, result);
  RepeatedSolver solver(uncollided, setup.directions, setup.options);
  steps.take(solver);
  std::optional<Solution> solution = steps.solution();
  if (!solution) return std::nullopt;
  solver.read(reader);
  uncollided.finish(*solution);
  return solution;
}

}  // namespace etendue
