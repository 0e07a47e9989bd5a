// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/solve/iterate_emission.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/field_view.h"
#include "solver/solution/following_emission.h"
#include "solver/transport/sweep/finite_check.h"

namespace etendue {
namespace {

/// Error of the light for each error of the emission: a tenth hardly slows the emission down.
constexpr double share_of_light = 0.1;
constexpr double coarsest = 0.02;  ///< error of the first light
/// Sweeps of the tolerance that the last iteration is left with.
constexpr int last_sweeps = 2;

/// [cell][4][band]; constant elements have their value at every vertex.
std::vector<double> fluence_of(const TransportSweep& sweep, const TransportState& state) {
  const auto bands = static_cast<std::size_t>(sweep.problem().band_count());
  const auto cells = static_cast<std::size_t>(sweep.mesh().cell_count());
  const auto nodes = static_cast<std::size_t>(sweep.cells().nodes());
  const auto stride = static_cast<std::size_t>(sweep.cells().stride());
  std::vector<double> fluence(cells * 4 * bands);
  const CellField values(fluence, bands);
  for (std::size_t c = 0; c < cells; ++c)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t b = 0; b < bands; ++b)
        values(c, i, b) = state.fluence()[(c * nodes + i % nodes) * stride + b];
  return fluence;
}

/// The steps from one emission to the next.
class EmissionSteps {
 public:
  EmissionSteps(const IterationSetup& setup, Problem& problem, TransportState& state)
      : setup_(setup), emission_(*setup.options.following_emission), problem_(problem), state_(state) {}

  void run() {
    const double tolerance = setup_.options.tolerance;
    while (true) {
      problem_.set_following_emission(emission_.emission());
      find_light(std::clamp(share_of_light * error_, tolerance / 2, coarsest));
      ++steps_;
      error_ = emission_.improve(fluence_of(setup_.sweep, state_));
      problem_.set_following_emission(emission_.emission());
      if (error_ <= tolerance || interrupted_ || !has_sweeps_left()) return;
    }
  }

  int sweeps() const { return sweeps_; }
  const std::vector<HistoryEntry>& history() const { return history_; }

  std::string note() const {
    return fmt::format("{} steps to the temperatures, {} sweeps; {}", steps_, sweeps_, emission_.note());
  }
  bool converged() const { return error_ <= setup_.options.tolerance; }
  bool interrupted() const { return interrupted_; }
  double error() const { return error_; }

 private:
  bool has_sweeps_left() const { return sweeps_ + last_sweeps < setup_.options.max_sweeps; }

  /// Brings the state to the light of this emission.
  void find_light(double tolerance) {
    if (setup_.sweep.is_direct()) return sweep_once();
    const IterationOptions limits{tolerance, setup_.options.max_sweeps - sweeps_ - last_sweeps + 1,
                                  setup_.low_order.acceleration(), setup_.low_order.judge(), setup_.single};
    const auto shifted = [&](const SweepProgress& progress) { return observe(progress); };
    const IterationResult result =
        make_iteration(setup_.options.method)->run(setup_.sweep, state_, limits, SolveObserver(shifted));
    for (HistoryEntry entry : result.history) {
      entry.sweep += sweeps_;
      history_.push_back(entry);
    }
    sweeps_ += result.sweeps;
    interrupted_ = result.interrupted;
  }

  void sweep_once() {
    TransportState next(setup_.sweep.layout());
    setup_.sweep.apply(state_, next);
    check_finite(setup_.sweep, ++sweeps_, next);
    state_ = std::move(next);
    for (int band = 0; band < problem_.band_count(); ++band) history_.push_back({sweeps_, band, error_});
    SweepProgress progress;
    progress.sweep = 0;
    const std::vector<double> residual(static_cast<std::size_t>(problem_.band_count()), error_);
    progress.residual = residual;
    interrupted_ = observe(progress) == SolveControl::stop;
  }

  SolveControl observe(const SweepProgress& progress) const {
    if (!setup_.observer) return SolveControl::proceed;
    SweepProgress all = progress;
    all.sweep += sweeps_;
    all.max_sweeps = setup_.options.max_sweeps;
    all.tolerance = setup_.options.tolerance;
    all.seconds_left = -1;  // that of this emission alone is known
    return setup_.observer(all);
  }

  const IterationSetup& setup_;
  FollowingEmission& emission_;
  Problem& problem_;
  TransportState& state_;
  double error_ = 1;
  int steps_ = 0;
  int sweeps_ = 0;
  bool interrupted_ = false;
  std::vector<HistoryEntry> history_;
};

}  // namespace

void iterate_emission(const IterationSetup& setup, Problem& problem, TransportState& state,
                      SweepRecord& record, Solution& solution) {
  EmissionSteps steps(setup, problem, state);
  steps.run();
  SolveOptions options = setup.options;
  options.max_sweeps = std::max(1, options.max_sweeps - steps.sweeps());
  const auto shifted = [&](const SweepProgress& progress) {
    SweepProgress all = progress;
    all.sweep += steps.sweeps();
    all.max_sweeps = setup.options.max_sweeps;
    return steps.interrupted() ? SolveControl::stop : setup.observer(all);
  };
  const SolveObserver observer = setup.observer ? SolveObserver(shifted) : SolveObserver();
  iterate({setup.sweep, setup.single, setup.low_order, options, observer}, state, record, solution);
  for (HistoryEntry& entry : solution.history) entry.sweep += steps.sweeps();
  solution.history.insert(solution.history.begin(), steps.history().begin(), steps.history().end());
  for (BandConvergence& band : solution.convergence) {
    band.sweeps += steps.sweeps();
    band.converged = band.converged && steps.converged();
    if (!steps.converged()) band.residual = std::max(band.residual, steps.error());
  }
  solution.interrupted = solution.interrupted || steps.interrupted();
  solution.notes.push_back(steps.note());
}

}  // namespace etendue
