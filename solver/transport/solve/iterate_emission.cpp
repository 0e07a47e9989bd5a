// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/solve/iterate_emission.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/field_view.h"
#include "solver/solution/following_emission.h"
#include "solver/transport/state/state_copy.h"
#include "solver/transport/sweep/finite_check.h"

namespace etendue {
namespace {

/// Error of the light for each error of the emission, at most and at least: a tenth hardly slows the emission
/// down where little light returns, and where much does errors of the light become larger ones of the
/// emission.
constexpr double largest_share = 0.1, smallest_share = 0.01;
/// Of the error that a step leaves, the part above which the share is divided by three.
constexpr double slow_step = 0.5;
constexpr double coarsest = 0.02;  ///< error of the first light
/// Sweeps of the tolerance that the last iteration is left with.
constexpr int last_sweeps = 2;

/// Values [item][vertices][band] of a part of a state, [item][nodes][stride]; constant elements have their
/// value at every vertex.
template <std::size_t vertices>
std::vector<double> at_vertices(std::span<const double> part, std::size_t items, std::size_t stride,
                                std::size_t bands) {
  const std::size_t nodes = part.size() / (items * stride);
  std::vector<double> result(items * vertices * bands);
  const FieldView<double, vertices> values(result, bands);
  for (std::size_t item = 0; item < items; ++item)
    for (std::size_t i = 0; i < vertices; ++i)
      for (std::size_t b = 0; b < bands; ++b)
        values(item, i, b) = part[(item * nodes + i % nodes) * stride + b];
  return result;
}

/// Progress whose state is that of the emission too.
SweepProgress with_emission(const SweepProgress& progress, const FollowingEmission& emission) {
  SweepProgress all = progress;
  all.state = [light = progress.state, &emission] {
    SavedState state = light();
    state.following = emission.state();
    return state;
  };
  return all;
}

/// The steps from one emission to the next.
class EmissionSteps {
 public:
  EmissionSteps(const IterationSetup& setup, Problem& problem, TransportState& state)
      : setup_(setup), emission_(*setup.options.following_emission), problem_(problem), state_(state) {}

  void run() {
    const double tolerance = setup_.options.tolerance;
    problem_.set_following(emission_.sources());
    while (has_sweeps_left()) {
      find_light(std::clamp(share_ * error_, tolerance / 2, coarsest));
      ++steps_;
      const double before = std::exchange(error_, improve());
      if (error_ > slow_step * before) share_ = std::max(share_ / 3, smallest_share);
      problem_.set_following(emission_.sources());
      if (error_ <= tolerance || interrupted_) return;
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
    const IterationOptions limits{.tolerance = tolerance,
                                  .max_sweeps = setup_.options.max_sweeps - sweeps_ - last_sweeps + 1,
                                  .acceleration = setup_.low_order.acceleration(),
                                  .judge = setup_.low_order.judge(),
                                  .single = setup_.single,
                                  .coarse = setup_.coarse,
                                  .trusts_estimate = true};
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
    progress.state = [&] { return saved(state_, problem_.band_count()); };
    const std::vector<double> residual(static_cast<std::size_t>(problem_.band_count()), error_);
    progress.residual = residual;
    interrupted_ = observe(progress) == SolveControl::stop;
  }

  SolveControl observe(const SweepProgress& progress) const {
    if (!setup_.observer) return SolveControl::proceed;
    SweepProgress all = with_emission(progress, emission_);
    all.sweep += sweeps_;
    all.max_sweeps = setup_.options.max_sweeps;
    all.tolerance = setup_.options.tolerance;
    all.seconds_left = -1;  // that of this emission alone is known
    return setup_.observer(all);
  }

  const IterationSetup& setup_;
  double improve() {
    const auto bands = static_cast<std::size_t>(problem_.band_count());
    const auto stride = static_cast<std::size_t>(setup_.sweep.cells().stride());
    const TransportState& state = state_;
    const std::vector<double> fluence = at_vertices<4>(
        state.fluence(), static_cast<std::size_t>(setup_.sweep.mesh().cell_count()), stride, bands);
    const std::vector<double> irradiance =
        at_vertices<3>(state.irradiance(),
                       static_cast<std::size_t>(setup_.sweep.mesh().boundary_face_count()), stride, bands);
    return emission_.improve({fluence, irradiance, setup_.sweep.walls().half_range()});
  }

  FollowingEmission& emission_;
  Problem& problem_;
  TransportState& state_;
  double error_ = 1;
  double share_ = largest_share;
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
    SweepProgress all = with_emission(progress, *setup.options.following_emission);
    all.sweep += steps.sweeps();
    all.max_sweeps = setup.options.max_sweeps;
    return steps.interrupted() ? SolveControl::stop : setup.observer(all);
  };
  const SolveObserver observer = setup.observer ? SolveObserver(shifted) : SolveObserver();
  iterate({setup.sweep, setup.single, setup.coarse, setup.low_order, options, observer}, state, record,
          solution);
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
