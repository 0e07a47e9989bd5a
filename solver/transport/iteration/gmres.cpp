// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/iteration/gmres.h"

#include <fmt/format.h>
#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "solver/solution/solve_observer.h"
#include "solver/transport/acceleration/diffusion_acceleration.h"
#include "solver/transport/iteration/band_vectors.h"
#include "solver/transport/iteration/residual.h"
#include "solver/transport/order/sweep_stopped.h"
#include "solver/transport/state/state_copy.h"
#include "solver/transport/sweep/finite_check.h"

namespace etendue {
namespace {

/// The residual that GMRES carries along may differ from the true one: aim a little below the tolerance.
constexpr double safety = 0.5;
/// Residual fraction of an error after a cycle whose sweeps are in single precision. Less would be their
/// rounding, 1e-7 to 4e-7 of what each is given: in a void a cycle that goes on to 5e-7 takes twice as many
/// sweeps.
constexpr double single_cycle = 1e-6;
/// Relative residuals below this are rounding.
constexpr double rounding = 1e-15;

/// The small least-squares problem of one band: the Hessenberg matrix of I - T on the basis.
class BandHessenberg {
 public:
  explicit BandHessenberg(double start) : start_(start) {}

  void add_column(const std::vector<double>& entries) {
    const auto columns = static_cast<Eigen::Index>(entries.size()) - 1;
    matrix_.conservativeResizeLike(Eigen::MatrixXd::Zero(columns + 1, columns));
    for (Eigen::Index i = 0; i <= columns; ++i)
      matrix_(i, columns - 1) = entries[static_cast<std::size_t>(i)];
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix_, Eigen::ComputeThinU | Eigen::ComputeThinV);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(columns + 1);
    right(0) = start_;
    // Of a singular matrix the error is unknown, not infinite.
    smallest_ = std::clamp(svd.singularValues().minCoeff(), std::numeric_limits<double>::epsilon(), 1.0);
    solution_ = svd.solve(right);
    residual_ = right - matrix_ * solution_;
  }

  /// Of any size.
  double residual() const { return residual_.stableNorm(); }
  /// Coefficient of a basis vector in the residual.
  double residual_coefficient(std::size_t row) const {
    return static_cast<Eigen::Index>(row) < residual_.size() ? residual_(static_cast<Eigen::Index>(row)) : 0;
  }
  double smallest_singular_value() const { return smallest_; }
  double coefficient(std::size_t column) const {
    return static_cast<Eigen::Index>(column) < solution_.size() ? solution_(static_cast<Eigen::Index>(column))
                                                                : 0;
  }

 private:
  double start_;
  double smallest_ = 1;
  Eigen::VectorXd residual_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd solution_;
};

/// One run: what its cycles share.
class Run {
 public:
  Run(TransportSweep& sweep, TransportState& state, const IterationOptions& options,
      const SolveObserver& observer, std::size_t memory)
      : sweep_(sweep),
        state_(state),
        options_(options),
        observer_(observer),
        vectors_(sweep.mesh(), sweep),
        bands_(static_cast<std::size_t>(sweep.cells().bands())),
        work_(state.layout()),
        judge_(options.acceleration != nullptr ? options.acceleration : options.judge),
        corrected_(judge_ != nullptr ? state.layout() : StateLayout{}),
        length_(std::clamp(memory / (state.layout().total() * sizeof(double)), shortest_krylov_basis,
                           longest_krylov_basis)),
        done_(bands_, 0),
        smallest_(bands_, 1) {
    result_.bands.resize(bands_);
  }

  IterationResult run() try {
    while (sweeps_ < options_.max_sweeps && !result_.interrupted) {
      // Of those that the cycle has found done the true residual is still to be seen.
      for (std::size_t b = 0; b < bands_; ++b) done_[b] = result_.bands[b].converged;
      const std::vector<char> taking_part = active();
      // After a cycle this sweep is most likely the last.
      SweepRecord* record = measured_ ? options_.record : nullptr;
      const std::vector<double> errors = true_errors(record);
      for (std::size_t b = 0; b < bands_; ++b) {
        if (done_[b]) continue;
        result_.bands[b].residual = errors[b];
        // Without acceleration the residual after the first sweep says only that something shines.
        result_.bands[b].converged =
            (measured_ || accelerated(b) || errors[b] <= rounding) && errors[b] <= options_.tolerance;
      }
      const bool proceeds =
          report(taking_part) && !all_converged() && sweeps_ < options_.max_sweeps && !stagnates(errors);
      if (!proceeds) {
        take_image();
        result_.recorded = record != nullptr;
        break;
      }
      // With no sweep left for a cycle the image is what is better than the state.
      if (cycle_ends())
        take_image();
      else
        cycle();
      measured_ = true;
    }
    result_.sweeps = sweeps_;
    return std::move(result_);
  } catch (const SweepStopped&) {
    add_correction(state_);
    throw;
  }

 private:
  bool accelerated() const { return options_.acceleration != nullptr; }
  bool accelerated(std::size_t band) const { return accelerated() && options_.acceleration->acts_on(band); }
  /// Whether |P r| is an estimate of the error in this band, accelerated or not.
  bool judged(std::size_t band) const { return judge_ != nullptr && judge_->acts_on(band); }
  /// Whether a cycle has to end. A recorded sweep is to follow.
  bool cycle_ends() const {
    return sweeps_ + (options_.record != nullptr ? 1 : 0) >= options_.max_sweeps || result_.interrupted;
  }
  bool all_converged() const {
    return std::all_of(result_.bands.begin(), result_.bands.end(), [](const auto& b) { return b.converged; });
  }

  /// work_ = F(state) - state, and the relative error that it tells of.
  std::vector<double> true_errors(SweepRecord* record) {
    sweep_.apply(state_, work_, record);
    ++sweeps_;
    check_finite(sweep_, sweeps_, work_);
    vectors_.add(work_, BandScalars(bands_, -1), state_);
    if (accelerated()) precondition(active());
    std::vector<double> errors = relative_change(sweep_.mesh(), sweep_, state_, judged_residual());
    for (std::size_t b = 0; b < bands_; ++b)
      errors[b] = judged(b)            ? errors[b] * judge_->caution(b)
                  : sweep_.is_direct() ? 0
                                       : errors[b] / smallest_[b];
    check_finite(sweep_, sweeps_, "residual", errors);
    return errors;
  }

  /// P r of what work_ holds, where P is not in it already but only judges.
  const TransportState& judged_residual() {
    if (accelerated() || judge_ == nullptr) return work_;
    judge_->apply(work_, corrected_, active());
    return corrected_;
  }

  /// Whether the last cycle, which should have ended the iteration, has hardly changed the true error, for
  /// the second time: only rounding remains.
  bool stagnates(const std::vector<double>& errors) {
    const double error = *std::max_element(errors.begin(), errors.end());
    const bool as_before = measured_ && found_done_ && error > 0.5 * last_error_;
    last_error_ = error;
    vain_cycles_ = as_before ? vain_cycles_ + 1 : 0;
    if (vain_cycles_ < 2) return false;
    result_.notes.push_back(
        fmt::format("rounding leaves an error of about {:.1e}; a tolerance below that is not met", error));
    return true;
  }

  /// state = F(state), from what true_errors() has left behind.
  void take_image() { vectors_.add(state_, BandScalars(bands_, 1), accelerated() ? corrected_ : work_); }

  /// work_ = P work_
  void precondition(const std::vector<char>& active) {
    options_.acceleration->apply(work_, corrected_, active);
    std::swap(work_, corrected_);
  }

  /// work_ = T v
  void apply_linear(const TransportState& v) {
    if (options_.single != nullptr) {
      options_.single->apply_linear(v, work_, active());
    } else {
      sweep_.apply_linear(v, work_, active());
    }
  }

  void cycle() {
    basis_.clear();
    find_goals();
    problems_.clear();
    const BandScalars start = vectors_.norm(work_);
    size_ = vectors_.norm(state_);
    if (judge_ != nullptr)
      field_ = field_norms(sweep_.mesh(), sweep_, state_, accelerated() ? work_ : corrected_);
    for (std::size_t b = 0; b < bands_; ++b) {
      // From nothing the first residual is the size of the answer.
      size_[b] = std::max(size_[b], start[b]);
      done_[b] = result_.bands[b].converged || start[b] == 0;
      problems_.emplace_back(done_[b] ? 0 : start[b]);
    }
    push_normalised(start);
    for (std::size_t j = 0; j < length_ && !cycle_ends(); ++j) {
      apply_linear(basis_[j]);
      ++sweeps_;
      check_finite(sweep_, sweeps_, work_);
      // work = P (I - T) v
      vectors_.scale(work_, BandScalars(bands_, -1));
      vectors_.add(work_, BandScalars(bands_, 1), basis_[j]);
      const std::vector<char> taking_part = active();
      if (accelerated()) precondition(taking_part);
      add_columns(orthogonalise());
      estimate();
      if (!report(taking_part) || std::count(done_.begin(), done_.end(), 0) == 0) break;
    }
    found_done_ = std::count(done_.begin(), done_.end(), 0) == 0;
    add_correction(state_);
    basis_.clear();
  }

  /// The errors at which the cycle is done.
  void find_goals() {
    goal_.clear();
    for (const BandConvergence& band : result_.bands)
      goal_.push_back(std::max(safety * options_.tolerance,
                               options_.single != nullptr ? single_cycle * band.residual : 0));
  }

  /// What the cycle has found so far.
  void add_correction(TransportState& to) const {
    for (std::size_t j = 0; j < basis_.size(); ++j) {
      BandScalars factor;
      for (const BandHessenberg& problem : problems_) factor.push_back(problem.coefficient(j));
      vectors_.add(to, factor, basis_[j]);
    }
  }

  std::vector<char> active() const {
    std::vector<char> result;
    for (const char done : done_) result.push_back(!done);
    return result;
  }

  SavedState best_state() const {
    TransportState best = state_;
    add_correction(best);
    return saved(best, static_cast<int>(bands_));
  }

  void push_normalised(const BandScalars& norm) {
    BandScalars factor;
    for (std::size_t b = 0; b < bands_; ++b) factor.push_back(norm[b] > 0 && !done_[b] ? 1 / norm[b] : 0);
    basis_.push_back(work_);
    vectors_.scale(basis_.back(), factor);
  }

  /// Gram-Schmidt, twice (Giraud et al. 2005): [band][basis vector, then the new norm].
  std::vector<std::vector<double>> orthogonalise() {
    std::vector<std::vector<double>> columns(bands_, std::vector<double>(basis_.size() + 1, 0));
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t i = 0; i < basis_.size(); ++i) {
        BandScalars projection = vectors_.dot(basis_[i], work_);
        for (std::size_t b = 0; b < bands_; ++b) {
          columns[b][i] += projection[b];
          projection[b] = -projection[b];
        }
        vectors_.add(work_, projection, basis_[i]);
      }
    const BandScalars norm = vectors_.norm(work_);
    check_finite(sweep_, sweeps_, "Krylov vector", norm);
    for (std::size_t b = 0; b < bands_; ++b) columns[b].back() = norm[b];
    push_normalised(norm);
    return columns;
  }

  void add_columns(const std::vector<std::vector<double>>& columns) {
    for (std::size_t b = 0; b < bands_; ++b) {
      if (done_[b]) continue;
      problems_[b].add_column(columns[b]);
      smallest_[b] = std::min(smallest_[b], problems_[b].smallest_singular_value());
    }
  }

  /// Estimated relative errors of the bands that are not done yet: |P r| / |phi|, or |r| / (s |x|).
  void estimate() {
    std::vector<double> errors(bands_, 0);
    if (judge_ != nullptr) {
      std::fill(corrected_.values().begin(), corrected_.values().end(), 0.0);
      for (std::size_t j = 0; j < basis_.size(); ++j) {
        BandScalars factor;
        for (std::size_t b = 0; b < bands_; ++b)
          factor.push_back(done_[b] ? 0 : problems_[b].residual_coefficient(j));
        vectors_.add(corrected_, factor, basis_[j]);
      }
      if (!accelerated()) {
        // The place to work in is free until the next sweep.
        judge_->apply(corrected_, work_, active());
        std::swap(corrected_, work_);
      }
      errors = relative_size(sweep_.mesh(), sweep_, corrected_, field_);
    }
    for (std::size_t b = 0; b < bands_; ++b) {
      if (done_[b]) continue;
      errors[b] =
          judged(b) ? errors[b] * judge_->caution(b) : problems_[b].residual() / (smallest_[b] * size_[b]);
      result_.bands[b].residual = errors[b];
      done_[b] = errors[b] <= goal_[b];
    }
  }

  /// Counts a sweep of the bands that took part in it. False where the observer wants to stop.
  bool report(const std::vector<char>& taking_part) {
    std::vector<double> errors;
    for (std::size_t b = 0; b < bands_; ++b) {
      errors.push_back(result_.bands[b].residual);
      if (!taking_part[b]) continue;
      ++result_.bands[b].sweeps;
      result_.history.push_back({sweeps_, static_cast<int>(b), errors.back()});
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const SweepProgress progress{sweeps_,
                                 options_.max_sweeps,
                                 errors,
                                 options_.tolerance,
                                 seconds,
                                 seconds_left(*std::max_element(errors.begin(), errors.end()), seconds),
                                 [this] { return best_state(); }};
    if (!observer_ || observer_(progress) == SolveControl::proceed) return true;
    result_.interrupted = !all_converged();
    return false;
  }

  double seconds_left(double error, double seconds) {
    first_error_ = std::max(first_error_, error);
    if (error <= options_.tolerance) return 0;
    if (error >= first_error_) return -1;
    const double progress = std::log(first_error_ / error) / std::log(first_error_ / options_.tolerance);
    // Whole sweeps, and one that finds the true residual.
    const double sweep = seconds / sweeps_;
    return sweep * (std::ceil(seconds * (1 - progress) / progress / sweep) + 1);
  }

  TransportSweep& sweep_;
  TransportState& state_;
  const IterationOptions& options_;
  const SolveObserver& observer_;
  BandVectors vectors_;
  std::size_t bands_;
  TransportState work_;
  DiffusionAcceleration* judge_;  ///< its |P r| is an estimate of the error; null: there is none
  TransportState corrected_;      ///< where P writes; empty without one
  std::size_t length_;
  std::vector<TransportState> basis_;  ///< of the cycle under way; empty between cycles
  std::vector<BandHessenberg> problems_;
  std::vector<char> done_;        ///< [band]
  std::vector<double> goal_;      ///< [band] error at which the cycle is done
  BandScalars size_;              ///< of the state when the cycle began
  FieldNorms field_;              ///< of the fluence and the walls' irradiance then
  std::vector<double> smallest_;  ///< [band] smallest singular value of I - T seen so far
  IterationResult result_;
  int sweeps_ = 0;
  bool measured_ = false;
  bool found_done_ = false;  ///< whether the last cycle ended because all bands seemed done
  double last_error_ = 0;    ///< the largest true one when it began
  int vain_cycles_ = 0;      ///< that left it as it was, one after the other
  double first_error_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

IterationResult Gmres::run(TransportSweep& sweep, TransportState& state, const IterationOptions& options,
                           const SolveObserver& observer) {
  return Run(sweep, state, options, observer, memory_).run();
}

}  // namespace etendue
