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
#include "solver/solution/balance.h"
#include "solver/transport/sweep/finite_check.h"
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
        numbers_(setup.input, setup.problem, setup.locator),
        frames_(frame_times(*setup.input.time)) {}

  void take(const UncollidedLight& uncollided) {
    StepsInTime& taken = result_.steps.emplace();
    taken.quantities = numbers_.quantities();
    taken.of = "temperature";
    try {
      solver_.emplace(uncollided, setup_.directions, setup_.options);
      const auto light = [&] {
        Solution solution = solver_->solve();
        add(seconds_, solution.seconds);
        return solution;
      };
      march_heat(setup_.temperatures, light, heat_step_plan(setup_.input),
                 [&](const HeatStep& step) { return read(step); });
    } catch (const SolveStopped&) {
      result_.interrupted = true;
    } catch (const std::domain_error&) {
      end_with("time.tolerance asks for steps below a billionth of until; give a larger one, or even steps");
    } catch (const InputError& fault) {
      if (!last_) throw;
      end_with(fault.what());
    } catch (const NotFiniteError& fault) {
      if (!last_) throw;
      end_with(fault.what());
    }
  }

  /// At the end of the last whole step.
  std::optional<Solution> solution(const DirectionSetObserver& reader) {
    if (!last_) return std::nullopt;
    setup_.temperatures.start_from(last_->state.following);
    setup_.problem.set_following(setup_.temperatures.sources());
    solver_->read(reader);
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
    result_.residual = std::max(result_.residual, step.residual);
    if (!step.converged && last_) {
      end_with(
          fmt::format("the temperatures of the step to {:.6g} s do not converge; take shorter steps, or "
                      "give time.tolerance",
                      step.end));
      return false;
    }
    setup_.problem.set_following(setup_.temperatures.sources());
    const HeatSolution heat = setup_.temperatures.solution();
    taken.steps.push_back(
        {step.end, step.error, step.missing, numbers_.values(step.solution, heat, step.stored), {}});
    double radiated = 0;  // in the step
    for (const Balance& band : balances(setup_.problem, step.solution))
      radiated += (band.emitted + band.inflow) * (step.end - step.begin);
    taken.largest_energy = std::max({taken.largest_energy, std::abs(step.stored), radiated});
    taken.sweeps = std::max(taken.sweeps, step.sweeps);
    result_.converged = result_.converged && step.converged;
    if (std::ranges::find(frames_, step.end) != frames_.end())
      taken.frames.push_back({step.end, heat.temperature});
    solver_->keep();
    last_ = std::move(step.solution);
    if (observer_.reached) observer_.reached(step.end / *setup_.input.time->until, *last_);
    const bool is_interrupted = observer_.interrupted && observer_.interrupted();
    result_.interrupted = result_.interrupted || (is_interrupted && step.end < *setup_.input.time->until);
    return !is_interrupted;
  }

  const HeatStepsSetup& setup_;
  const HeatStepsObserver& observer_;
  TimeResult& result_;
  HeatNumbers numbers_;
  std::vector<double> frames_;  ///< times of which fields are written [s]
  std::optional<RepeatedSolver> solver_;
  std::optional<Solution> last_;
  SolveSeconds seconds_;
};

}  // namespace

std::string heat_steps_text(const Case& input) {
  const TimeCase& time = *input.time;
  const double count = least_steps(time);
  return fmt::format("temperatures in time: {}{:.0f} steps of {:.4g} s, to {:.4g} s\n",
                     heat_step_plan(input).tolerance > 0 ? "at least " : "", count, *time.until / count,
                     *time.until);
}

std::size_t heat_steps_memory(const Case& input, const Problem& problem, const SolveOptions& options) {
  const auto corners = static_cast<std::size_t>(4 * problem.mesh().cell_count());
  const auto bands = static_cast<std::size_t>(problem.band_count());
  // Fluence and flux, of the solution, its swept part and those of the step before, and emission that
  // follows.
  const std::size_t fields = 4 * 4 + 4 + 3 * options.keep_ordinates.size();
  return sizeof(double) * corners * (fields * bands + static_cast<std::size_t>(input.time->frames));
}

std::optional<Solution> take_heat_steps(const HeatStepsSetup& setup, UncollidedLight& uncollided,
                                        const HeatStepsObserver& observer, const DirectionSetObserver& reader,
                                        TimeResult& result) {
  HeatSteps steps(setup, observer, result);
  steps.take(uncollided);
  std::optional<Solution> solution = steps.solution(reader);
  if (!solution) return std::nullopt;
  uncollided.finish(*solution);
  return solution;
}

}  // namespace etendue
