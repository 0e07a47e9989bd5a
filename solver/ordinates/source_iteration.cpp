// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/ordinates/source_iteration.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "solver/ordinates/band_vectors.h"
#include "solver/ordinates/diffusion_acceleration.h"
#include "solver/ordinates/residual.h"

namespace etendue {
namespace {

/// Residuals that the rate is measured over: light that bounces to and fro makes single ratios alternate.
constexpr std::size_t rate_window = 4;
/// A rate above this is not told apart from 1 by residuals with rounding errors.
constexpr double largest_rate = 1 - 1e-12;
/// Residuals below this are rounding.
constexpr double rounding = 1e-15;

/// state <- F(state), or state + P (F(state) - state) where it is accelerated; `next` is a place to work in.
/// Gives the relative size of the change in each band. Only `active` bands are accelerated.
std::vector<double> advance(TransportSweep& sweep, TransportState& state, TransportState& next,
                            DiffusionAcceleration* acceleration, const std::vector<char>& active) {
  const BandVectors vectors(sweep.mesh(), sweep);
  const auto bands = static_cast<std::size_t>(sweep.cells().bands());
  sweep.apply(state, next);
  vectors.add(next, BandScalars(bands, -1), state);
  if (acceleration != nullptr) {
    TransportState corrected(state.layout());
    acceleration->apply(next, corrected, active);
    std::swap(next, corrected);
  }
  std::vector<double> change = relative_change(sweep.mesh(), sweep, state, next);
  vectors.add(state, BandScalars(bands, 1), next);
  return change;
}

}  // namespace

double RateEstimate::error(double residual) {
  residuals_.push_back(residual);
  if (residual <= rounding) return error_ = residual;
  if (residuals_.size() < 2) return error_ = std::max(residual, 1.0);
  const std::size_t span = std::min(rate_window, residuals_.size() - 1);
  const double before = residuals_[residuals_.size() - 1 - span];
  const double mean = std::pow(residual / before, 1.0 / static_cast<double>(span));
  const double last = residual / residuals_[residuals_.size() - 2];
  // The slower of the last step and the mean over the window.
  rate_ = std::min(std::max(mean, last), largest_rate);
  return error_ = residual / (1 - rate_);
}

double RateEstimate::sweeps_left(double tolerance) const {
  if (error_ <= tolerance) return 0;
  if (rate_ >= largest_rate || rate_ <= 0 || residuals_.size() < 2) return -1;
  return std::ceil(std::log(tolerance / error_) / std::log(rate_));
}

IterationResult SourceIteration::run(TransportSweep& sweep, TransportState& state,
                                     const IterationOptions& options, const SolveObserver& observer) {
  const auto start = std::chrono::steady_clock::now();
  const auto bands = static_cast<std::size_t>(sweep.cells().bands());
  IterationResult result;
  result.bands.resize(bands);
  std::vector<RateEstimate> rates(bands);
  std::vector<double> errors(bands, 0);
  TransportState next(state.layout());
  std::vector<char> active(bands, 1);
  for (int count = 1; count <= options.max_sweeps; ++count) {
    const std::vector<double> residual = advance(sweep, state, next, options.acceleration, active);
    result.sweeps = count;
    double left = 0;
    bool done = true;
    for (std::size_t b = 0; b < bands; ++b) {
      if (!active[b]) continue;
      // Asked in any case, for the sweeps that are left. |P r| is an estimate of the error itself.
      const double from_rate = rates[b].error(residual[b]);
      const bool corrected = options.acceleration != nullptr && options.acceleration->acts_on(b);
      errors[b] = sweep.is_direct() ? 0
                  : corrected       ? residual[b] * options.acceleration->caution(b)
                                    : from_rate;
      const bool converged = errors[b] <= options.tolerance;
      result.bands[b] = {count, errors[b], converged};
      result.history.push_back({count, static_cast<int>(b), errors[b]});
      active[b] = !converged;
      done = done && converged;
      const double band_left = sweep.is_direct() ? 0 : rates[b].sweeps_left(options.tolerance);
      left = left < 0 || band_left < 0 ? -1 : std::max(left, band_left);
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double seconds_left = left < 0 ? -1 : left * seconds / count;
    const SweepProgress progress{
        count, options.max_sweeps, errors, options.tolerance, seconds, seconds_left, [&] {
          return saved(state, sweep.cells().bands());
        }};
    if (observer && observer(progress) == SolveControl::stop) {
      result.interrupted = !done;
      break;
    }
    if (done) break;
  }
  return result;
}

}  // namespace etendue
