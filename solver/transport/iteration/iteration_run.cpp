// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/iteration/iteration_run.h"

#include <algorithm>
#include <utility>

#include "solver/transport/order/sweep_stopped.h"
#include "solver/transport/state/state_copy.h"
#include "solver/transport/sweep/finite_check.h"

namespace etendue {

IterationRun::IterationRun(TransportSweep& sweep, TransportState& state, const IterationOptions& options,
                           const SolveObserver& observer)
    : sweep_(sweep),
      state_(state),
      options_(options),
      vectors_(sweep.mesh(), sweep),
      bands_(static_cast<std::size_t>(sweep.cells().bands())),
      observer_(observer) {
  result_.bands.resize(bands_);
}

IterationResult IterationRun::run() try {
  while (!ended_ && !result_.interrupted && sweeps_left() > 0 && !all_converged()) step();
  finish();
  return std::move(result_);
} catch (const SweepStopped&) {
  abandon();
  throw;
}

SavedState IterationRun::best_state() const { return saved(state_, static_cast<int>(bands_)); }

bool IterationRun::all_converged() const {
  return std::ranges::all_of(result_.bands, [](const BandConvergence& band) { return band.converged; });
}

std::vector<double> IterationRun::errors() const {
  std::vector<double> errors;
  for (const BandConvergence& band : result_.bands) errors.push_back(band.residual);
  return errors;
}

void IterationRun::check(const TransportState& state) const { check_finite(sweep_, result_.sweeps, state); }

void IterationRun::check(std::string_view quantity, std::span<const double> sizes) const {
  check_finite(sweep_, result_.sweeps, quantity, sizes);
}

void IterationRun::record(std::size_t band, const BandConvergence& convergence) {
  result_.bands[band] = convergence;
  result_.history.push_back({result_.sweeps, static_cast<int>(band), convergence.residual});
}

bool IterationRun::report() {
  const std::vector<double> residual = errors();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const SweepProgress progress{result_.sweeps,
                               options_.max_sweeps,
                               residual,
                               options_.tolerance,
                               seconds,
                               seconds_left(seconds),
                               [this] { return best_state(); }};
  if (!observer_ || observer_(progress) == SolveControl::proceed) return true;
  result_.interrupted = !all_converged();
  return false;
}

}  // namespace etendue
