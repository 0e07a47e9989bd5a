// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/solve/iterate.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "solver/transport/iteration/gmres.h"
#include "solver/transport/iteration/positive_iteration.h"
#include "solver/transport/iteration/source_iteration.h"
#include "solver/transport/sweep/finite_check.h"

namespace etendue {
namespace {

bool keeps_positive(const SolveOptions& options) {
  return options.positivity != Positivity::none && options.order == SpaceOrder::linear;
}

/// Returns true where the initial state has values that were kept positive, so that the linear problem needs
/// no iteration.
bool starts_positive(const SolveOptions& options) {
  return keeps_positive(options) && options.initial != nullptr &&
         std::ranges::all_of(options.initial->fluence, [](double value) { return value >= 0; });
}

/// Result of an iteration that had nothing to do.
IterationResult untouched(int bands) {
  IterationResult result;
  result.bands.assign(static_cast<std::size_t>(bands), {0, 0, true});
  return result;
}

/// Sweeps of the linear iteration.
struct SweepsUsed {
  int count = 1;          ///< with the one that is recorded
  bool recorded = false;  ///< whether the last of them was recorded
};

/// Copies convergence, history and notes of the linear iteration, to which `used` sweeps are added.
void take_result(const IterationSetup& setup, IterationResult&& result, int used, Solution& solution) {
  solution.convergence = std::move(result.bands);
  solution.history = std::move(result.history);
  solution.interrupted = result.interrupted;
  for (BandConvergence& band : solution.convergence) band.sweeps += used;
  if (setup.single != nullptr && setup.single->band_sweep_count() > 0)
    solution.notes.push_back(
        fmt::format("{} sweeps of a band in single precision, within cycles that double precision corrects",
                    setup.single->band_sweep_count()));
  if (setup.coarse != nullptr && setup.coarse->sweeps() > 0)
    solution.notes.push_back(fmt::format("corrected on {} directions ({}), in {} sweeps",
                                         setup.coarse->count(), setup.coarse->name(),
                                         setup.coarse->sweeps()));
  if (setup.low_order.accelerates)
    for (std::string& note : setup.low_order.diffusion->notes()) solution.notes.push_back(std::move(note));
  std::move(result.notes.begin(), result.notes.end(), std::back_inserter(solution.notes));
}

/// Solves the linear problem.
SweepsUsed iterate_linearly(const IterationSetup& setup, TransportState& state, SweepRecord& record,
                            Solution& solution) {
  const SolveOptions& options = setup.options;
  const int bands = setup.sweep.problem().band_count();
  if (setup.sweep.is_direct() || options.max_sweeps == 1) {
    // Without an iteration the only sweep is the one that is recorded, and its error is zero or unknown.
    const bool is_direct = setup.sweep.is_direct();
    solution.convergence.assign(static_cast<std::size_t>(bands), {1, is_direct ? 0.0 : 1.0, is_direct});
    return {};
  }
  const std::unique_ptr<Iteration> iteration = make_iteration(options.method);
  int used = setup.low_order.diffusion ? setup.low_order.diffusion->sweeps() : 0;
  // The sweep that is recorded is one of those that are allowed: the last of the iteration or one more.
  const bool records = iteration->records() && options.positivity == Positivity::none;
  if (!records) ++used;
  const IterationOptions limits{.tolerance = options.tolerance,
                                .max_sweeps = options.max_sweeps - used,
                                .acceleration = setup.low_order.acceleration(),
                                .judge = setup.low_order.judge(),
                                .single = setup.single,
                                .coarse = setup.coarse,
                                .record = records ? &record : nullptr};
  IterationResult result = starts_positive(options)
                               ? untouched(bands)
                               : iteration->run(setup.sweep, state, limits, setup.observer);
  const bool recorded = result.recorded;
  if (records && !recorded) ++used;
  const int sweeps = used + result.sweeps;
  take_result(setup, std::move(result), used, solution);
  return {sweeps, recorded};
}

/// Adds the result of the iteration that keeps values positive to that of the linear one, which took `used`
/// sweeps.
void add_positive_result(const IterationResult& result, int used, Solution& solution) {
  for (std::size_t b = 0; b < result.bands.size(); ++b) {
    BandConvergence band = result.bands[b];
    band.sweeps += used;
    band.converged = band.converged && solution.convergence[b].converged;
    solution.convergence[b] = band;
  }
  solution.notes.push_back(fmt::format("{} sweeps to keep values positive", result.sweeps));
  for (HistoryEntry entry : result.history) {
    entry.sweep += used - 1;
    solution.history.push_back(entry);
  }
  solution.interrupted = result.interrupted;
}

/// Continues from the solution of the linear problem with values that are kept positive, for as many sweeps
/// as remain after `used`.
void keep_positive(const IterationSetup& setup, int used, TransportState& state, Solution& solution) {
  const SolveOptions& options = setup.options;
  setup.sweep.keep_positive(options.positivity == Positivity::rescale ? Fixup::rescale : Fixup::quadratic);
  if (setup.sweep.is_direct() || solution.interrupted) return;
  if (options.max_sweeps <= used) {
    for (BandConvergence& band : solution.convergence) band.converged = false;
    solution.notes.push_back(
        "not converged: no sweeps are left after the linear solution to keep values positive");
    return;
  }
  const auto shifted = [&](const SweepProgress& progress) {
    SweepProgress all = progress;
    all.sweep += used - 1;
    all.max_sweeps = options.max_sweeps;
    return setup.observer(all);
  };
  const IterationOptions limits{options.tolerance, options.max_sweeps - used, setup.low_order.acceleration()};
  const IterationResult result = PositiveIteration().run(
      setup.sweep, state, limits, setup.observer ? SolveObserver(shifted) : SolveObserver());
  add_positive_result(result, used, solution);
}

}  // namespace

std::unique_ptr<Iteration> make_iteration(Method method) {
  if (method == Method::source_iteration) return std::make_unique<SourceIteration>();
  return std::make_unique<Gmres>();
}

const char* iteration_name(Method method) { return make_iteration(method)->name(); }

void iterate(const IterationSetup& setup, TransportState& state, SweepRecord& record, Solution& solution) {
  const SweepsUsed used = iterate_linearly(setup, state, record, solution);
  if (keeps_positive(setup.options)) keep_positive(setup, used.count, state, solution);
  if (used.recorded) return;
  TransportState last_state(setup.sweep.layout());
  setup.sweep.apply(state, last_state, &record);
  check_finite(setup.sweep, used.count, last_state);
  state = std::move(last_state);
}

}  // namespace etendue
