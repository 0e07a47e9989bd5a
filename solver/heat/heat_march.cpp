// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/heat/heat_march.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "solver/solution/solve_observer.h"

namespace etendue {
namespace {

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

class HeatMarch {
 public:
  HeatMarch(TemperatureIteration& temperatures, const LightSolver& solver, const StepPlan& plan)
      : temperatures_(temperatures), solver_(solver), plan_(plan) {}

  void run(const HeatStepReader& reader) {
    take_all_steps(plan_, [&](double begin, double length, double end) {
      return take_step(begin, length, end, reader);
    });
  }

 private:
  std::optional<double> take_step(double begin, double length, double end, const HeatStepReader& reader) {
    const std::vector<double> state = temperatures_.state();
    const std::vector<double> before = temperatures_.temperature();
    step_ = {};
    const bool by_differences = plan_.method == StepMethod::bdf2 && !last_.empty() && length == last_length_;
    double error = by_differences ? differences(before, length, end) : stages(before, begin, length, end);
    // Where the iteration fails, shorter steps may help it.
    if (!step_.converged && plan_.tolerance > 0) error = std::numeric_limits<double>::infinity();
    if (!plan_.accepts(error)) {
      temperatures_.start_from(state);
      return error;
    }
    std::vector<double> gained = temperatures_.storage().heat(before, temperatures_.temperature());
    stored_ += sum(gained);
    last_ = std::move(gained);
    last_change_ = difference(temperatures_.temperature(), before);
    last_length_ = length;
    const HeatStep taken{
        begin, end, error, step_.missing, stored_, step_.sweeps, step_.residual, step_.converged, solution_};
    return reader(taken) ? std::optional<double>(error) : std::nullopt;
  }

  /// In first order the temperatures would be those before and the slope of the first stage times the step.
  double stages(const std::vector<double>& before, double begin, double length, double end) {
    const double stage = sdirk_gamma * length;
    solve({begin + stage, stage, before, std::vector<double>(before.size(), 0)}, (1 - sdirk_gamma) * length);
    const std::vector<double> first = temperatures_.temperature();
    const double rest = (1 - sdirk_gamma) / sdirk_gamma;
    solve({end, stage, before, scaled(temperatures_.storage().heat(before, first), rest)}, stage);
    std::vector<double> estimate = difference(temperatures_.temperature(), before);
    for (std::size_t i = 0; i < estimate.size(); ++i) estimate[i] -= (first[i] - before[i]) / sdirk_gamma;
    return norm(estimate);
  }

  double differences(const std::vector<double>& before, double length, double end) {
    const double stage = bdf2_part * length;
    solve({end, stage, before, scaled(last_, 1.0 / 3)}, stage);
    std::vector<double> estimate = difference(temperatures_.temperature(), before);
    for (std::size_t i = 0; i < estimate.size(); ++i) estimate[i] = (estimate[i] - last_change_[i]) / 2;
    return norm(estimate);
  }

  /// `weight` is the part of the step that its heat flows in [s].
  void solve(HeatStage stage, double weight) {
    temperatures_.set_stage(std::move(stage));
    solution_ = solver_();
    if (solution_.interrupted) throw SolveStopped{};
    int sweeps = 0;
    for (const BandConvergence& band : solution_.convergence) {
      sweeps = std::max(sweeps, band.sweeps);
      step_.residual = std::max(step_.residual, band.residual);
    }
    step_.sweeps += sweeps;
    step_.converged = step_.converged && solution_.converged();
    step_.missing += weight * std::abs(temperatures_.missing_heat(solution_));
  }

  static std::vector<double> difference(std::vector<double> x, const std::vector<double>& y) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] -= y[i];
    return x;
  }

  /// Root mean square of changes of temperatures, weighted by heat capacities, over the highest temperature.
  double norm(const std::vector<double>& changes) const {
    const std::vector<double> weights = temperatures_.storage().capacity(temperatures_.temperature());
    double squares = 0;
    for (std::size_t i = 0; i < changes.size(); ++i) squares += weights[i] * changes[i] * changes[i];
    const double weight = sum(weights);
    return weight > 0 ? std::sqrt(squares / weight) / highest_temperature(temperatures_.temperature()) : 0;
  }

  /// What the solutions of a step were.
  struct Solved {
    double missing = 0;
    int sweeps = 0;
    double residual = 0;
    bool converged = true;
  };

  TemperatureIteration& temperatures_;
  const LightSolver& solver_;
  const StepPlan& plan_;
  Solved step_;
  Solution solution_;
  std::vector<double> last_;         ///< [unknown] heat stored in the last step [J]; empty: there was none
  std::vector<double> last_change_;  ///< [unknown] of the temperatures in it [K]
  double last_length_ = 0;
  double stored_ = 0;
};

}  // namespace

void march_heat(TemperatureIteration& temperatures, const LightSolver& solver, const StepPlan& plan,
                const HeatStepReader& reader) {
  HeatMarch(temperatures, solver, plan).run(reader);
}

}  // namespace etendue
