// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/ordinates/positive_iteration.h"

#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <deque>
#include <utility>

#include "solver/ordinates/band_vectors.h"
#include "solver/ordinates/residual.h"

namespace etendue {
namespace {

/// The fluence and what walls and lagged faces hand on are not negative; moments may be.
void clip(TransportState& state) {
  for (const std::span<double> part : {state.fluence(), state.irradiance(), state.mirrors(), state.lagged()})
    for (double& value : part) value = std::max(value, 0.0);
  // Moment 0 repeats the fluence and is not read from there.
}

/// One step of the past: the changes of residual and image.
struct Change {
  TransportState residual;
  TransportState image;
};

class Run {
 public:
  Run(TransportSweep& sweep, TransportState& state, const IterationOptions& options,
      const SolveObserver& observer)
      : sweep_(sweep),
        state_(state),
        options_(options),
        observer_(observer),
        vectors_(sweep.mesh(), sweep),
        bands_(static_cast<std::size_t>(sweep.cells().bands())),
        image_(state.layout()),
        smallest_(bands_, 1) {
    result_.bands.resize(bands_);
  }

  IterationResult run() {
    clip(state_);
    for (int count = 1; count <= options_.max_sweeps; ++count) {
      TransportState last_image = image_;
      sweep_.apply(state_, image_);
      const std::vector<double> relative = relative_residual(sweep_.mesh(), sweep_, state_, image_);
      TransportState residual = difference(image_, state_);
      if (count > 1) remember(residual, last_image);
      result_.sweeps = count;
      for (std::size_t b = 0; b < bands_; ++b) {
        const double error = relative[b] / smallest_[b];
        // One residual says nothing of the rate, unless it is zero.
        result_.bands[b] = {count, error, error <= options_.tolerance && (count > 1 || error == 0)};
        result_.history.push_back({count, static_cast<int>(b), error});
      }
      const bool done = std::all_of(result_.bands.begin(), result_.bands.end(),
                                    [](const BandConvergence& band) { return band.converged; });
      residual_ = std::move(residual);
      if (done) {
        state_ = image_;
      } else {
        step();
      }
      if (stopped(count)) {
        result_.interrupted = !done;
        break;
      }
      if (done) break;
    }
    return std::move(result_);
  }

 private:
  TransportState difference(const TransportState& a, const TransportState& b) const {
    TransportState result = a;
    vectors_.add(result, BandScalars(bands_, -1), b);
    return result;
  }

  void remember(const TransportState& residual, const TransportState& last_image) {
    Change change{difference(residual, residual_), difference(image_, last_image)};
    // The change of the state is that of the image less that of the residual.
    const BandScalars of_residual = vectors_.norm(change.residual);
    const BandScalars of_state = vectors_.norm(difference(change.image, change.residual));
    for (std::size_t b = 0; b < bands_; ++b)
      if (of_state[b] > 0 && of_residual[b] > 0)
        smallest_[b] = std::min(smallest_[b], of_residual[b] / of_state[b]);
    changes_.push_back(std::move(change));
    if (changes_.size() > anderson_memory) changes_.pop_front();
  }

  /// state = image - sum of gamma_j change of image j, gamma the least squares of the residual.
  void step() {
    state_ = image_;
    if (changes_.empty()) return;
    const auto count = static_cast<Eigen::Index>(changes_.size());
    std::vector<Eigen::MatrixXd> gram(bands_, Eigen::MatrixXd(count, count));
    std::vector<Eigen::VectorXd> right(bands_, Eigen::VectorXd(count));
    for (Eigen::Index i = 0; i < count; ++i) {
      const TransportState& row = changes_[static_cast<std::size_t>(i)].residual;
      const BandScalars product = vectors_.dot(row, residual_);
      for (std::size_t b = 0; b < bands_; ++b) right[b](i) = product[b];
      for (Eigen::Index j = i; j < count; ++j) {
        const BandScalars entry = vectors_.dot(row, changes_[static_cast<std::size_t>(j)].residual);
        for (std::size_t b = 0; b < bands_; ++b) gram[b](i, j) = gram[b](j, i) = entry[b];
      }
    }
    std::vector<Eigen::VectorXd> gamma;
    for (std::size_t b = 0; b < bands_; ++b)
      gamma.push_back(gram[b].completeOrthogonalDecomposition().solve(right[b]));
    for (Eigen::Index j = 0; j < count; ++j) {
      BandScalars factor;
      for (std::size_t b = 0; b < bands_; ++b) factor.push_back(-gamma[b](j));
      vectors_.add(state_, factor, changes_[static_cast<std::size_t>(j)].image);
    }
    clip(state_);
  }

  bool stopped(int count) {
    std::vector<double> errors;
    for (const BandConvergence& band : result_.bands) errors.push_back(band.residual);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const SweepProgress progress{count, options_.max_sweeps, errors, options_.tolerance, seconds, -1, [this] {
                                   return saved(state_, static_cast<int>(bands_));
                                 }};
    return observer_ && observer_(progress) == SolveControl::stop;
  }

  TransportSweep& sweep_;
  TransportState& state_;
  const IterationOptions& options_;
  const SolveObserver& observer_;
  BandVectors vectors_;
  std::size_t bands_;
  TransportState image_;              ///< F of the state
  TransportState residual_ = image_;  ///< F of the state, less the state
  std::deque<Change> changes_;        ///< the oldest first
  std::vector<double> smallest_;      ///< [band]
  IterationResult result_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

IterationResult PositiveIteration::run(TransportSweep& sweep, TransportState& state,
                                       const IterationOptions& options, const SolveObserver& observer) {
  return Run(sweep, state, options, observer).run();
}

}  // namespace etendue
