// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/iteration/positive_iteration.h"

#include <Eigen/Dense>
#include <algorithm>
#include <deque>
#include <utility>

#include "solver/transport/acceleration/diffusion_acceleration.h"
#include "solver/transport/iteration/gmres.h"
#include "solver/transport/iteration/iteration_run.h"
#include "solver/transport/iteration/residual.h"
#include "solver/transport/state/safe_squares.h"

namespace etendue {
namespace {

/// The fluence and what walls and lagged faces hand on are not negative; moments may be.
void clip(TransportState& state) {
  for (const std::span<double> part : {state.fluence(), state.irradiance(), state.mirrors(), state.lagged()})
    for (double& value : part) value = std::max(value, 0.0);
  // Moment 0 repeats the fluence and is not read from there.
}

/// Of the residual with diffusion in the first step, when nothing is known of its eigenvalues.
constexpr double first_mixed = 0.1;

/// One step of the past: the changes of residual and image.
struct Change {
  TransportState residual;
  TransportState image;
};

/// One run of the iteration that keeps values positive.
class PositiveRun : public IterationRun {
 public:
  PositiveRun(TransportSweep& sweep, TransportState& state, const IterationOptions& options,
              const SolveObserver& observer)
      : IterationRun(sweep, state, options, observer),
        memory_(anderson_memory(static_cast<double>(state.layout().total()))),
        image_(state.layout()),
        smallest_(bands_, 1),
        largest_(bands_, 1) {
    clip(state_);
  }

 private:
  void step() override {
    TransportState last_image = image_;
    sweep_.apply(state_, image_);
    ++result_.sweeps;
    check(image_);
    TransportState residual = difference(image_, state_);
    if (options_.acceleration != nullptr) precondition(residual);
    const std::vector<double> relative = relative_residual(sweep_.mesh(), sweep_, state_, image_);
    check("residual", relative);
    const bool is_first = result_.sweeps == 1;
    if (!is_first) remember(residual, last_image);
    for (std::size_t b = 0; b < bands_; ++b) {
      const double error =
          relative[b] / smallest_[b] * (accelerated(b) ? options_.acceleration->caution(b) : 1);
      // One residual tells nothing of the rate, unless it is zero or P has taken the rate out.
      const bool is_known = !is_first || accelerated(b) || error == 0;
      record(b, {result_.sweeps, error, error <= options_.tolerance && is_known});
    }
    residual_ = std::move(residual);
    keep_if_best();
    if (all_converged()) {
      state_ = image_;
      clip(state_);
    } else {
      extrapolate();
    }
    report();
  }

  // Steps may lead away, so the best state that was seen is the result.
  void finish() override {
    if (all_converged() || best_errors_.empty()) return;
    state_ = best_;
    for (std::size_t b = 0; b < bands_; ++b) result_.bands[b].residual = best_errors_[b];
  }

  void abandon() override {
    if (!best_errors_.empty()) state_ = best_;
  }

  double seconds_left(double) override { return -1; }

  /// Keeps the best of the states whose errors are known.
  void keep_if_best() {
    std::vector<double> now = errors();
    if (!best_errors_.empty() && std::ranges::max(now) >= std::ranges::max(best_errors_)) return;
    best_ = state_;
    best_errors_ = std::move(now);
  }

  bool accelerated(std::size_t band) const {
    return options_.acceleration != nullptr && options_.acceleration->acts_on(band);
  }

  /// a + factor b
  TransportState sum(const TransportState& a, double factor, const TransportState& b) const {
    TransportState result = a;
    vectors_.add(result, BandScalars(bands_, factor), b);
    return result;
  }
  TransportState difference(const TransportState& a, const TransportState& b) const { return sum(a, -1, b); }

  /// residual = P residual, and the image that goes with it.
  void precondition(TransportState& residual) {
    TransportState corrected(state_.layout());
    options_.acceleration->apply(residual, corrected, std::vector<char>(bands_, 1));
    residual = std::move(corrected);
    image_ = sum(state_, 1, residual);
  }

  void remember(const TransportState& residual, const TransportState& last_image) {
    Change change{difference(residual, residual_), difference(image_, last_image)};
    // The change of the state is that of the image less that of the residual.
    const BandScalars of_residual = vectors_.norm(change.residual);
    const BandScalars of_state = vectors_.norm(difference(change.image, change.residual));
    for (std::size_t b = 0; b < bands_; ++b) {
      if (of_state[b] <= 0 || of_residual[b] <= 0) continue;
      smallest_[b] = std::min(smallest_[b], of_residual[b] / of_state[b]);
      largest_[b] = std::max(largest_[b], of_residual[b] / of_state[b]);
    }
    changes_.push_back(std::move(change));
    if (changes_.size() > memory_) changes_.pop_front();
  }

  /// state = image - sum of gamma_j change of image j, gamma the least squares of the residual, of which only
  /// the part `mixed` is taken: with diffusion P (I - F) may have large eigenvalues, since in thick cells
  /// values that are kept positive diffuse faster than the linear ones.
  void extrapolate() {
    TransportState rest = residual_;
    state_ = image_;
    if (!changes_.empty()) {
      const std::vector<Eigen::VectorXd> gamma = least_squares();
      for (std::size_t j = 0; j < changes_.size(); ++j) {
        BandScalars factor;
        for (std::size_t b = 0; b < bands_; ++b) factor.push_back(-gamma[b](static_cast<Eigen::Index>(j)));
        vectors_.add(state_, factor, changes_[j].image);
        vectors_.add(rest, factor, changes_[j].residual);
      }
    }
    BandScalars left_out;
    for (std::size_t b = 0; b < bands_; ++b) left_out.push_back(mixed(b) - 1);
    vectors_.add(state_, left_out, rest);
    clip(state_);
  }

  double mixed(std::size_t band) const {
    if (!accelerated(band)) return 1;
    return changes_.empty() ? first_mixed : std::min(1.0, 1 / largest_[band]);
  }

  /// [band] the factors of the changes of the residual whose sum is nearest to it.
  std::vector<Eigen::VectorXd> least_squares() const {
    const auto count = static_cast<Eigen::Index>(changes_.size());
    std::vector<Eigen::MatrixXd> gram(bands_, Eigen::MatrixXd(count, count));
    std::vector<Eigen::VectorXd> right(bands_, Eigen::VectorXd(count));
    BandScalars unit = vectors_.norm(residual_);
    for (double& value : unit) value = unit_for_squares(value);
    for (Eigen::Index i = 0; i < count; ++i) {
      const TransportState& row = changes_[static_cast<std::size_t>(i)].residual;
      const BandScalars product = vectors_.dot(row, residual_, unit);
      for (std::size_t b = 0; b < bands_; ++b) right[b](i) = product[b];
      for (Eigen::Index j = i; j < count; ++j) {
        const BandScalars entry = vectors_.dot(row, changes_[static_cast<std::size_t>(j)].residual, unit);
        for (std::size_t b = 0; b < bands_; ++b) gram[b](i, j) = gram[b](j, i) = entry[b];
      }
    }
    std::vector<Eigen::VectorXd> gamma;
    for (std::size_t b = 0; b < bands_; ++b)
      gamma.push_back(gram[b].completeOrthogonalDecomposition().solve(right[b]));
    return gamma;
  }

  std::size_t memory_;                ///< steps
  TransportState image_;              ///< the state and its residual
  TransportState residual_ = image_;  ///< P (F(x) - x) of the state x
  TransportState best_ = image_;      ///< of smallest error so far
  std::vector<double> best_errors_;   ///< [band] of that; empty: there is none yet
  std::deque<Change> changes_;        ///< the oldest first
  std::vector<double> smallest_;      ///< [band] |change of residual| / |change of state| seen so far
  std::vector<double> largest_;       ///< [band] the same
};

}  // namespace

std::size_t anderson_memory(double state_size) {
  const double fitting = static_cast<double>(krylov_memory) / (2 * sizeof(double) * state_size);
  return static_cast<std::size_t>(std::clamp(fitting, static_cast<double>(shortest_anderson_memory),
                                             static_cast<double>(longest_anderson_memory)));
}

IterationResult PositiveIteration::run(TransportSweep& sweep, TransportState& state,
                                       const IterationOptions& options, const SolveObserver& observer) {
  return PositiveRun(sweep, state, options, observer).run();
}

}  // namespace etendue
