// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "app/accuracy/convergence_history.h"
#include "app/case/case.h"
#include "app/compare/error_estimate.h"
#include "app/compare/kept_run.h"

namespace etendue {

/// What a round refines: cells or directions.
enum class Refined { cells, directions };

/// How a round is finer than the one before.
struct NextRefinement {
  Refined what = Refined::cells;
  double factor = 2;  ///< by which the size of cells, or of directions, falls
};

/// One of the runs that lead to the accuracy.
struct AccuracyRound {
  KeptRun run;
  ErrorEstimate estimate;            ///< from this run and those before
  std::vector<std::size_t> asked;    ///< places of the numbers that are to be accurate
  std::optional<std::size_t> worst;  ///< of these, by error over what is allowed; empty: none is asked
  double excess = 0;                 ///< of the worst
  bool is_known = false;             ///< whether all parts of the errors are

  bool is_accurate() const { return is_known && excess <= 1; }
};

/// Runs, each finer than the last in cells or in directions, with the errors that are known after each.
class AccuracyRounds {
 public:
  /// `accuracy` must outlive it.
  explicit AccuracyRounds(const AccuracyCase& accuracy) : accuracy_(accuracy) {}

  /// Throws InputError where a name of the case means none of the numbers of the run.
  const AccuracyRound& add(KeptRun run);

  const std::vector<AccuracyRound>& all() const { return rounds_; }

  /// Refines the part with the largest error over what is allowed, by what that takes, at most 2; a part that
  /// is not known before others. There is a round, which is not accurate.
  NextRefinement next() const;

  /// What the iteration of the last round leaves, over what is allowed.
  double excess_of_iteration() const;

 private:
  /// [number]; empty where not known.
  std::vector<double> errors_of(Refined what, const KeptRun& run) const;
  /// Of one part of the last round, its largest error over what is allowed; infinite where not known.
  double excess_of(std::size_t part) const;
  ConvergenceHistory& history(Refined what) { return histories_[static_cast<std::size_t>(what)]; }
  const ConvergenceHistory& history(Refined what) const { return histories_[static_cast<std::size_t>(what)]; }

  const AccuracyCase& accuracy_;
  std::vector<AccuracyRound> rounds_;
  std::array<ConvergenceHistory, 2> histories_;
};

/// Size of the cells or of the directions of a run, each in a unit of its own.
double size_of(Refined what, const KeptRun& run);

}  // namespace etendue
