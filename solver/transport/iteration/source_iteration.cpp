// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/iteration/source_iteration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "solver/transport/acceleration/diffusion_acceleration.h"
#include "solver/transport/iteration/band_vectors.h"
#include "solver/transport/iteration/iteration_run.h"
#include "solver/transport/iteration/residual.h"
#include "solver/transport/kernel/sweep_kernel.h"

namespace etendue {
namespace {

/// Residuals that the rate is measured over: light that bounces to and fro makes single ratios alternate.
constexpr std::size_t rate_window = 4;
/// A rate above this cannot be distinguished from 1 by residuals with rounding errors.
constexpr double largest_rate = 1 - 1e-12;

/// Steps over which an iteration that converges does not fail to shorten them.
constexpr std::size_t divergence_window = 20;

/// F of those bands that are still iterated. Once a band is done the others are swept by the linear part T
/// alone, in fewer lanes, and F(0) is added: the first image where the iteration began in
/// darkness, and else a sweep more.
class Image {
 public:
  Image(TransportSweep& sweep, const TransportState& start)
      : sweep_(sweep),
        vectors_(sweep.mesh(), sweep),
        bands_(static_cast<std::size_t>(sweep.cells().bands())),
        is_dark_(std::all_of(start.values().begin(), start.values().end(), [](double v) { return v == 0; })) {
  }

  /// next = F(state) in the bands that are `active`, in `most` sweeps. Gives how many it took.
  int form(const TransportState& state, TransportState& next, const std::vector<char>& active, int most) {
    const bool some_are_done = std::count(active.begin(), active.end(), 0) > 0;
    const bool asks_darkness = some_are_done && !of_darkness_ && most > 1 && saves_lanes(active);
    if (asks_darkness) sweep_.apply(TransportState(state.layout()), of_darkness_.emplace(state.layout()));
    if (some_are_done && of_darkness_) {
      TransportState left = state;
      vectors_.scale(left, BandScalars(active.begin(), active.end()));
      sweep_.apply_linear(left, next, active);
      vectors_.add(next, BandScalars(bands_, 1), *of_darkness_);
      return asks_darkness ? 2 : 1;
    }
    sweep_.apply(state, next);
    if (is_dark_ && bands_ > 1) of_darkness_.emplace(next);
    is_dark_ = false;
    return 1;
  }

 private:
  bool saves_lanes(const std::vector<char>& active) const {
    return lane_stride(static_cast<int>(std::count(active.begin(), active.end(), 1))) <
           sweep_.cells().stride();
  }

  TransportSweep& sweep_;
  BandVectors vectors_;
  std::size_t bands_;
  bool is_dark_;                               ///< whether the next state is darkness
  std::optional<TransportState> of_darkness_;  ///< F(0), where it is known
};

/// One run of source iteration.
class SourceRun : public IterationRun {
 public:
  SourceRun(TransportSweep& sweep, TransportState& state, const IterationOptions& options,
            const SolveObserver& observer)
      : IterationRun(sweep, state, options, observer),
        image_(sweep, state),
        next_(state.layout()),
        judge_(options.acceleration != nullptr ? options.acceleration : options.judge),
        corrected_(judge_ != nullptr ? state.layout() : StateLayout{}),
        rates_(bands_),
        sizes_(bands_),
        active_(bands_, 1),
        accelerated_(bands_, 0) {
    for (std::size_t b = 0; b < bands_; ++b)
      accelerated_[b] = options.acceleration != nullptr && options.acceleration->acts_on(b);
  }

 private:
  void step() override {
    judge(advance());
    report();
  }

  /// state <- F(state), or state + P (F(state) - state) in bands that are accelerated. Returns the relative
  /// size of the change.
  std::vector<double> advance() {
    result_.sweeps += image_.form(state_, next_, active_, sweeps_left());
    check(next_);
    vectors_.add(next_, BandScalars(bands_, -1), state_);
    vectors_.scale(next_, BandScalars(active_.begin(), active_.end()));
    std::vector<double> change;
    if (judge_ != nullptr) {
      judge_->apply(next_, corrected_, active_);
      change = relative_change(sweep_.mesh(), sweep_, state_, corrected_);
      take_corrected();
    } else {
      change = relative_change(sweep_.mesh(), sweep_, state_, next_);
    }
    vectors_.add(state_, BandScalars(bands_, 1), next_);
    check("residual", change);
    return change;
  }

  /// next = corrected in bands that are accelerated.
  void take_corrected() {
    vectors_.scale(corrected_, BandScalars(accelerated_.begin(), accelerated_.end()));
    BandScalars plain;
    for (const char accelerated : accelerated_) plain.push_back(accelerated ? 0 : 1);
    vectors_.scale(next_, plain);
    vectors_.add(next_, BandScalars(bands_, 1), corrected_);
  }

  /// Estimates the errors by equation (14), or as |P r| / |phi|.
  void judge(const std::vector<double>& residual) {
    const BandScalars size = vectors_.norm(next_);
    for (std::size_t b = 0; b < bands_; ++b) {
      if (!active_[b]) continue;
      if (diverges(b, size[b])) continue_plainly(b);
      // Asked in any case, for the sweeps that are left. |P r| is an estimate of the error itself.
      const double from_rate = rates_[b].error(residual[b]);
      const double error = sweep_.is_direct() ? 0 : judged(b) ? residual[b] * judge_->caution(b) : from_rate;
      const bool converged = error <= options_.tolerance;
      record(b, {result_.sweeps, error, converged});
      active_[b] = !converged;
      accelerated_[b] = accelerated_[b] && !converged;
    }
  }

  bool judged(std::size_t b) const { return judge_ != nullptr && judge_->acts_on(b); }

  bool diverges(std::size_t b, double size) {
    sizes_[b].push_back(size);
    const std::size_t count = sizes_[b].size();
    return accelerated_[b] && count > divergence_window && size >= sizes_[b][count - 1 - divergence_window];
  }

  void continue_plainly(std::size_t b) {
    accelerated_[b] = 0;
    result_.notes.push_back(
        fmt::format("source iteration with diffusion diverges in band {}: plain from sweep {} on",
                    sweep_.problem().bands().names[b], result_.sweeps + 1));
  }

  double seconds_left(double seconds) override {
    double left = 0;
    for (std::size_t b = 0; b < bands_; ++b) {
      const double band_left = active_[b] ? rates_[b].sweeps_left(options_.tolerance) : 0;
      left = left < 0 || band_left < 0 ? -1 : std::max(left, band_left);
    }
    return left < 0 ? -1 : left * seconds / result_.sweeps;
  }

  Image image_;
  TransportState next_;
  DiffusionAcceleration* judge_;  ///< |P r| is an estimate of the error; null: there is none
  TransportState corrected_;      ///< P r
  std::vector<RateEstimate> rates_;
  std::vector<std::vector<double>> sizes_;  ///< [band][step] norm of the step
  std::vector<char> active_;                ///< [band]
  std::vector<char> accelerated_;           ///< [band] of those that are active
};

}  // namespace

double RateEstimate::error(double residual) {
  residuals_.push_back(residual);
  if (residual <= smallest_residual) return error_ = residual;
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
  return SourceRun(sweep, state, options, observer).run();
}

}  // namespace etendue
