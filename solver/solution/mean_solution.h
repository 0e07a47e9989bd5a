// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/solution/solution.h"

namespace etendue {

/// Adds up solutions of one problem on sets of directions that differ in their rotation.
class MeanSolution {
 public:
  void add(const Solution& solution);
  int count() const { return count_; }
  /// Their mean, with direction_error where they are two or more. What belongs to ordinates (mirrors, lagged
  /// faces, radiance) is that of the first; sweeps and seconds are those of all together.
  Solution take() &&;

 private:
  void add_deviations(const Solution& solution);
  void add_iteration(const Solution& solution);

  Solution sum_;
  int count_ = 0;
  int sweeps_ = 0;                  ///< of the solutions before
  std::vector<double> mean_;        ///< [cell][band] of the fluence
  std::vector<double> deviations_;  ///< [cell][band] sum of squared deviations from the mean
};

}  // namespace etendue
