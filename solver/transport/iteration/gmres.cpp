// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/iteration/gmres.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>

#include "solver/transport/acceleration/diffusion_acceleration.h"
#include "solver/transport/iteration/coarse_correction.h"
#include "solver/transport/iteration/iteration_run.h"
#include "solver/transport/iteration/krylov_spaces.h"
#include "solver/transport/iteration/residual.h"
#include "solver/transport/state/state_copy.h"

namespace etendue {
namespace {

/// The residual that GMRES carries along may differ from the true one: aim a little below the tolerance.
constexpr double safety = 0.5;
/// Residual fraction of an error after a cycle whose sweeps are in single precision. Less would be their
/// rounding, 1e-7 to 4e-7 of what each is given: in a void a cycle that continues to 5e-7 takes twice as many
/// sweeps.
constexpr double single_cycle = 1e-6;
/// The same that shows that rounding in single precision is too large: of light that returns too often.
constexpr double vain_single_cycle = 1e-3;

/// Part of a vector that a correction on fewer directions leaves of it, unless the cycle needs less. The
/// sweep that follows leaves more, what the directions do not share.
constexpr double corrected_part = 0.05;
/// Vectors that a cycle with corrections holds at least.
constexpr std::size_t shortest_corrected = 2 * CoarseCorrection::longest_basis + 4;

/// One cycle.
struct Cycle {
  /// [basis vector] that took its place in front of the sweep; none: the vector itself.
  std::vector<std::optional<TransportState>> corrected;
  std::vector<double> goal;  ///< [band] error at which the cycle is done
  BandScalars size;          ///< of the state when the cycle began
  FieldNorms field;          ///< of the fluence and the walls' irradiance then
  bool found_done = false;   ///< whether the last cycle ended because all bands seemed done
};

/// Finds out that only rounding remains.
class Stagnation {
 public:
  /// Takes the largest true error after each cycle; `converging`: whether the cycle should have ended the
  /// iteration. Returns whether that cycle has hardly changed the error, for the second time.
  bool is_reached(double error, bool converging) {
    vain_cycles_ = converging && error > 0.5 * last_error_ ? vain_cycles_ + 1 : 0;
    last_error_ = error;
    return vain_cycles_ >= 2;
  }

 private:
  double last_error_ = 0;
  int vain_cycles_ = 0;  ///< that left the error as it was, one after the other
};

/// One run of GMRES.
class GmresRun : public IterationRun {
 public:
  GmresRun(TransportSweep& sweep, TransportState& state, const IterationOptions& options,
           const SolveObserver& observer, std::size_t memory)
      : IterationRun(sweep, state, options, observer),
        work_(state.layout()),
        single_(options.single),
        judge_(options.acceleration != nullptr ? options.acceleration : options.judge),
        corrected_(judge_ != nullptr ? state.layout() : StateLayout{}),
        length_(std::clamp(memory / (state.layout().total() * sizeof(double)), shortest_krylov_basis,
                           longest_krylov_basis)),
        spaces_(vectors_),
        done_(bands_, 0),
        smallest_(bands_, 1) {
    // Both hold vectors: those of the correction, and its results.
    if (options.coarse != nullptr && length_ >= shortest_corrected)
      correction_.emplace(*options.coarse, options.acceleration, vectors_,
                          static_cast<double>(options.coarse->count()) / sweep.directions().count());
  }

 private:
  /// Finds the true residual, and improves the state by a cycle.
  void step() override {
    // The true residual is still unknown in bands that the cycle has found done.
    for (std::size_t b = 0; b < bands_; ++b) done_[b] = result_.bands[b].converged;
    const std::vector<char> taking_part = active();
    // After a cycle this sweep is most likely the last.
    SweepRecord* record = measured_ ? options_.record : nullptr;
    const std::vector<double> errors = true_errors(record);
    for (std::size_t b = 0; b < bands_; ++b) {
      if (done_[b]) continue;
      result_.bands[b].residual = errors[b];
      // Without acceleration the residual after the first sweep shows only that there are sources.
      result_.bands[b].converged =
          (measured_ || accelerated(b) || errors[b] <= smallest_residual) && errors[b] <= options_.tolerance;
    }
    if (!report_sweep(taking_part) || all_converged() || sweeps_left() <= 0 || stagnates(errors)) {
      take_image();
      result_.recorded = record != nullptr;
      end();
      return;
    }
    watch_single(errors);
    // With no sweep left for a cycle the image is better than the state.
    if (cycle_ends())
      take_image();
    else
      cycle();
    measured_ = true;
    if (options_.trusts_estimate && meets_tolerance_by_estimate()) end_unconfirmed();
  }

  /// A cycle in single precision may have a goal above the tolerance.
  bool meets_tolerance_by_estimate() const {
    return cycle_.found_done && std::ranges::max(cycle_.goal) <= options_.tolerance;
  }

  void end_unconfirmed() {
    for (BandConvergence& band : result_.bands) band.converged = true;
    end();
  }

  void abandon() override { add_correction(state_); }

  bool accelerated() const { return options_.acceleration != nullptr; }
  bool accelerated(std::size_t band) const { return accelerated() && options_.acceleration->acts_on(band); }
  /// Whether |P r| is an estimate of the error in this band, accelerated or not.
  bool judged(std::size_t band) const { return judge_ != nullptr && judge_->acts_on(band); }
  /// Whether a cycle has to end. A recorded sweep is to follow.
  bool cycle_ends() const {
    return sweeps_left() <= (options_.record != nullptr ? 1 : 0) || result_.interrupted;
  }

  /// Sets work_ = F(state) - state and returns its estimate of the relative error, (14) or (D6).
  std::vector<double> true_errors(SweepRecord* record) {
    sweep_.apply(state_, work_, record);
    ++result_.sweeps;
    check(work_);
    vectors_.add(work_, BandScalars(bands_, -1), state_);
    if (accelerated()) precondition(active());
    std::vector<double> errors = relative_change(sweep_.mesh(), sweep_, state_, judged_residual());
    for (std::size_t b = 0; b < bands_; ++b)
      errors[b] = judged(b)            ? errors[b] * judge_->caution(b)
                  : sweep_.is_direct() ? 0
                                       : errors[b] / smallest_[b];
    check("residual", errors);
    return errors;
  }

  /// P r of the residual in work_, which has P in it already where P accelerates.
  const TransportState& judged_residual() {
    if (accelerated() || judge_ == nullptr) return work_;
    judge_->apply(work_, corrected_, active());
    return corrected_;
  }

  bool stagnates(const std::vector<double>& errors) {
    const double error = *std::max_element(errors.begin(), errors.end());
    if (!stagnation_.is_reached(error, measured_ && cycle_.found_done)) return false;
    result_.notes.push_back(
        fmt::format("rounding leaves an error of about {:.1e}; a tolerance below that is not met", error));
    return true;
  }

  /// Continues in double precision after a cycle in single that has not found what it seemed to find.
  void watch_single(const std::vector<double>& errors) {
    const double error = std::ranges::max(errors);
    if (single_ != nullptr && measured_ && cycle_.found_done &&
        error > std::max(vain_single_cycle * began_with_, 10 * std::ranges::max(cycle_.goal))) {
      single_ = nullptr;
      result_.notes.push_back(
          fmt::format("single precision does not suffice: double from sweep {} on", result_.sweeps + 1));
    }
    began_with_ = error;
  }

  /// state = F(state), from the residual of true_errors().
  void take_image() { vectors_.add(state_, BandScalars(bands_, 1), accelerated() ? corrected_ : work_); }

  /// work_ = P work_
  void precondition(const std::vector<char>& active) {
    options_.acceleration->apply(work_, corrected_, active);
    std::swap(work_, corrected_);
  }

  /// work_ = T v
  void apply_linear(const TransportState& v) {
    if (single_ != nullptr) {
      single_->apply_linear(v, work_, active());
    } else {
      sweep_.apply_linear(v, work_, active());
    }
  }

  void cycle() {
    begin_cycle();
    while (stored_vectors() <= length_ && !cycle_ends()) {
      const std::vector<char> taking_part = active();
      cycle_.corrected.push_back(corrected_on_fewer(taking_part));
      const bool is_corrected = cycle_.corrected.back().has_value();
      const TransportState& v = is_corrected ? *cycle_.corrected.back() : spaces_.last();
      apply_linear(v);
      ++result_.sweeps;
      check(work_);
      // work = P (I - T) v
      vectors_.scale(work_, BandScalars(bands_, -1));
      vectors_.add(work_, BandScalars(bands_, 1), v);
      if (accelerated()) precondition(taking_part);
      const BandScalars before = residuals();
      const KrylovSpaces::Columns columns = spaces_.orthogonalise(work_, taking_part);
      check_norms(columns);
      spaces_.add_columns(columns, taking_part);
      take_smallest();
      if (is_corrected) judge_correction(before, taking_part);
      estimate();
      if (!report_sweep(taking_part) || all_done()) break;
    }
    cycle_.found_done = all_done();
    add_correction(state_);
    spaces_.clear();
    cycle_.corrected.clear();
  }

  void check_norms(const KrylovSpaces::Columns& columns) const {
    BandScalars norms;
    for (const std::vector<double>& column : columns) norms.push_back(column.back());
    check("Krylov vector", norms);
  }

  std::size_t corrected_vectors() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(cycle_.corrected, [](const auto& vector) { return vector.has_value(); }));
  }

  std::size_t stored_vectors() const {
    const bool corrects = correction_ && !correction_->is_given_up();
    return spaces_.size() + corrected_vectors() + (corrects ? CoarseCorrection::longest_basis + 2 : 0);
  }

  /// The last vector, corrected on fewer directions where there are some and that pays.
  std::optional<TransportState> corrected_on_fewer(const std::vector<char>& active) {
    if (!correction_ || correction_->is_given_up()) return std::nullopt;
    double part = 0.5;
    for (std::size_t b = 0; b < bands_; ++b)
      if (active[b]) part = std::min(part, 0.5 * cycle_.goal[b] / result_.bands[b].residual);
    return correction_->solve(spaces_.last(), std::max(part, corrected_part), active);
  }

  void judge_correction(const BandScalars& before, const std::vector<char>& active) {
    correction_->judge(before, residuals(), active);
    if (correction_->is_given_up())
      result_.notes.push_back("corrections on fewer directions given up: they cost more than they saved");
  }

  BandScalars residuals() const {
    BandScalars result;
    for (std::size_t b = 0; b < bands_; ++b) result.push_back(spaces_.problem(b).residual());
    return result;
  }

  /// Of I - T: with corrected columns the product of two.
  void take_smallest() {
    const bool is_corrected = corrected_vectors() > 0;
    for (std::size_t b = 0; b < bands_; ++b)
      if (!done_[b])
        smallest_[b] =
            std::min(smallest_[b], spaces_.problem(b).smallest_singular_value() *
                                       (is_corrected ? correction_->smallest_singular_value(b) : 1));
  }

  bool all_done() const { return std::count(done_.begin(), done_.end(), 0) == 0; }

  void begin_cycle() {
    find_goals();
    const BandScalars start = vectors_.norm(work_);
    cycle_.size = vectors_.norm(state_);
    if (judge_ != nullptr)
      cycle_.field = field_norms(sweep_.mesh(), sweep_, state_, accelerated() ? work_ : corrected_);
    for (std::size_t b = 0; b < bands_; ++b) {
      // From nothing the first residual is the size of the answer.
      cycle_.size[b] = std::max(cycle_.size[b], start[b]);
      done_[b] = result_.bands[b].converged || start[b] == 0;
    }
    spaces_.begin(work_, start, active());
  }

  /// The errors at which the cycle is done.
  void find_goals() {
    cycle_.goal.clear();
    for (const BandConvergence& band : result_.bands)
      cycle_.goal.push_back(
          std::max(safety * options_.tolerance, single_ != nullptr ? single_cycle * band.residual : 0));
  }

  /// Adds the correction that the cycle has found so far.
  void add_correction(TransportState& to) const {
    for (std::size_t j = 0; j < cycle_.corrected.size(); ++j)
      vectors_.add(to, spaces_.coefficients(j),
                   cycle_.corrected[j] ? *cycle_.corrected[j] : spaces_.vector(j));
  }

  std::vector<char> active() const {
    std::vector<char> result;
    for (const char done : done_) result.push_back(!done);
    return result;
  }

  SavedState best_state() const override {
    TransportState best = state_;
    add_correction(best);
    return saved(best, static_cast<int>(bands_));
  }

  /// Estimated relative errors of the bands that are not done yet: |P r| / |phi|, or |r| / (s |x|).
  void estimate() {
    std::vector<double> errors(bands_, 0);
    if (judge_ != nullptr) {
      std::fill(corrected_.values().begin(), corrected_.values().end(), 0.0);
      for (std::size_t j = 0; j < spaces_.size(); ++j) {
        BandScalars factor;
        for (std::size_t b = 0; b < bands_; ++b)
          factor.push_back(done_[b] ? 0 : spaces_.problem(b).residual_coefficient(j));
        vectors_.add(corrected_, factor, spaces_.vector(j));
      }
      if (!accelerated()) {
        // The place to work in is free until the next sweep.
        judge_->apply(corrected_, work_, active());
        std::swap(corrected_, work_);
      }
      errors = relative_size(sweep_.mesh(), sweep_, corrected_, cycle_.field);
    }
    for (std::size_t b = 0; b < bands_; ++b) {
      if (done_[b]) continue;
      errors[b] = judged(b) ? errors[b] * judge_->caution(b)
                            : spaces_.problem(b).residual() / (smallest_[b] * cycle_.size[b]);
      result_.bands[b].residual = errors[b];
      done_[b] = errors[b] <= cycle_.goal[b];
    }
  }

  /// Counts a sweep of the bands that took part in it. Returns false where the observer stops the iteration.
  bool report_sweep(const std::vector<char>& taking_part) {
    for (std::size_t b = 0; b < bands_; ++b) {
      if (!taking_part[b]) continue;
      BandConvergence band = result_.bands[b];
      ++band.sweeps;
      record(b, band);
    }
    return report();
  }

  double seconds_left(double seconds) override {
    const double error = std::ranges::max(errors());
    first_error_ = std::max(first_error_, error);
    if (error <= options_.tolerance) return 0;
    if (error >= first_error_) return -1;
    const double progress = std::log(first_error_ / error) / std::log(first_error_ / options_.tolerance);
    // Whole sweeps, and one that finds the true residual.
    const double sweep = seconds / result_.sweeps;
    return sweep * (std::ceil(seconds * (1 - progress) / progress / sweep) + 1);
  }

  TransportState work_;
  SingleTransportSweep* single_;  ///< null: cycles in double precision
  double began_with_ = 0;         ///< the largest error before the last cycle
  DiffusionAcceleration* judge_;  ///< its |P r| is an estimate of the error; null: there is none
  TransportState corrected_;      ///< where P writes; empty without one
  std::size_t length_;            ///< Krylov vectors between restarts
  KrylovSpaces spaces_;           ///< empty between cycles
  Cycle cycle_;
  std::optional<CoarseCorrection> correction_;
  std::vector<char> done_;        ///< [band]
  std::vector<double> smallest_;  ///< [band] smallest singular value of I - T seen so far
  bool measured_ = false;         ///< whether a cycle has measured it
  Stagnation stagnation_;
  double first_error_ = 0;
};

}  // namespace

IterationResult Gmres::run(TransportSweep& sweep, TransportState& state, const IterationOptions& options,
                           const SolveObserver& observer) {
  return GmresRun(sweep, state, options, observer, memory_).run();
}

}  // namespace etendue
