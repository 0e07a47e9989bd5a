// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/ordinates/gmres.h"

#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "solver/ordinates/band_vectors.h"
#include "solver/ordinates/residual.h"

namespace etendue {
namespace {

/// The residual that GMRES carries along may differ from the true one: aim a little below the tolerance.
constexpr double safety = 0.5;
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
    smallest_ = std::min(1.0, svd.singularValues().minCoeff());
    solution_ = svd.solve(right);
    residual_ = (right - matrix_ * solution_).norm();
  }

  double residual() const { return residual_; }
  double smallest_singular_value() const { return smallest_; }
  double coefficient(std::size_t column) const {
    return static_cast<Eigen::Index>(column) < solution_.size() ? solution_(static_cast<Eigen::Index>(column))
                                                                : 0;
  }

 private:
  double start_;
  double residual_ = 0;
  double smallest_ = 1;
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
        length_(std::clamp(memory / (state.layout().total() * sizeof(double)), shortest_krylov_basis,
                           longest_krylov_basis)),
        smallest_(bands_, 1) {
    result_.bands.resize(bands_);
  }

  IterationResult run() {
    while (!finished()) {
      const std::vector<double> residual = true_residual();
      for (std::size_t b = 0; b < bands_; ++b) {
        const double error = sweep_.is_direct() ? 0 : residual[b] / smallest_[b];
        // After the first sweep from nothing the residual says only that something shines.
        result_.bands[b].residual = error;
        result_.bands[b].converged = (measured_ || residual[b] <= rounding) && error <= options_.tolerance;
      }
      if (!report() || all_converged() || finished()) break;
      cycle();
      measured_ = true;
    }
    return std::move(result_);
  }

 private:
  bool finished() const { return sweeps_ >= options_.max_sweeps || result_.interrupted; }
  bool all_converged() const {
    return std::all_of(result_.bands.begin(), result_.bands.end(), [](const auto& b) { return b.converged; });
  }

  /// work_ = F(state) - state
  std::vector<double> true_residual() {
    sweep_.apply(state_, work_);
    ++sweeps_;
    const std::vector<double> relative = relative_residual(sweep_.mesh(), sweep_, state_, work_);
    vectors_.add(work_, BandScalars(bands_, -1), state_);
    return relative;
  }

  void cycle() {
    basis_.clear();
    const BandScalars start = vectors_.norm(work_);
    const BandScalars size = vectors_.norm(state_);
    problems_.clear();
    for (std::size_t b = 0; b < bands_; ++b)
      problems_.emplace_back(result_.bands[b].converged ? 0 : start[b]);
    push_normalised(start);
    for (std::size_t j = 0; j < length_ && !finished(); ++j) {
      sweep_.apply_linear(basis_[j], work_);
      ++sweeps_;
      // work = (I - T) v
      vectors_.scale(work_, BandScalars(bands_, -1));
      vectors_.add(work_, BandScalars(bands_, 1), basis_[j]);
      const std::vector<std::vector<double>> columns = orthogonalise();
      bool done = true;
      for (std::size_t b = 0; b < bands_; ++b) {
        if (result_.bands[b].converged) continue;
        problems_[b].add_column(columns[b]);
        smallest_[b] = problems_[b].smallest_singular_value();
        // From nothing the first residual is the size of the answer.
        const double reference = std::max(size[b], start[b]);
        result_.bands[b].residual = reference > 0 ? problems_[b].residual() / (smallest_[b] * reference) : 0;
        done = done && result_.bands[b].residual <= safety * options_.tolerance;
      }
      if (!report() || done) break;
    }
    add_correction(state_);
    basis_.clear();
  }

  /// What the cycle has found so far.
  void add_correction(TransportState& to) const {
    for (std::size_t j = 0; j < basis_.size(); ++j) {
      BandScalars factor;
      for (const BandHessenberg& problem : problems_) factor.push_back(problem.coefficient(j));
      vectors_.add(to, factor, basis_[j]);
    }
  }

  SavedState best_state() const {
    TransportState best = state_;
    add_correction(best);
    return saved(best, static_cast<int>(bands_));
  }

  void push_normalised(const BandScalars& norm) {
    BandScalars factor;
    for (std::size_t b = 0; b < bands_; ++b)
      factor.push_back(norm[b] > 0 && !result_.bands[b].converged ? 1 / norm[b] : 0);
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
    for (std::size_t b = 0; b < bands_; ++b) columns[b].back() = norm[b];
    push_normalised(norm);
    return columns;
  }

  /// False where the observer wants to stop.
  bool report() {
    std::vector<double> errors;
    for (std::size_t b = 0; b < bands_; ++b) {
      result_.bands[b].sweeps = sweeps_;
      errors.push_back(result_.bands[b].residual);
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
    return seconds * (1 - progress) / progress;
  }

  TransportSweep& sweep_;
  TransportState& state_;
  const IterationOptions& options_;
  const SolveObserver& observer_;
  BandVectors vectors_;
  std::size_t bands_;
  TransportState work_;
  std::size_t length_;
  std::vector<TransportState> basis_;  ///< of the cycle under way; empty between cycles
  std::vector<BandHessenberg> problems_;
  std::vector<double> smallest_;  ///< [band] smallest singular value of I - T seen so far
  IterationResult result_;
  int sweeps_ = 0;
  bool measured_ = false;
  double first_error_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

IterationResult Gmres::run(TransportSweep& sweep, TransportState& state, const IterationOptions& options,
                           const SolveObserver& observer) {
  return Run(sweep, state, options, observer, memory_).run();
}

}  // namespace etendue
