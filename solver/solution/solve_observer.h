// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <span>

#include "solver/solution/saved_state.h"

namespace etendue {

/// State of the iteration after a sweep.
struct SweepProgress {
  int sweep = 0;  ///< from 1
  int max_sweeps = 0;
  std::span<const double> residual;  ///< [band] estimated relative error
  double tolerance = 0;
  double seconds = 0;       ///< since the first sweep began
  double seconds_left = 0;  ///< estimated from the measured rate of convergence; negative: unknown
  std::function<SavedState()> state = {};  ///< makes a copy of the best state so far
};

enum class SolveControl { proceed, stop };

/// Called after every sweep; may ask to stop, and then the best state so far is the solution.
using SolveObserver = std::function<SolveControl(const SweepProgress&)>;

/// A solution that ended within a sweep, as SolveOptions::stops wanted: there is no solution, but a state to
/// continue from.
struct SolveStopped {
  SavedState state;
};

}  // namespace etendue
