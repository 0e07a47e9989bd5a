// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "solver/stepping/step_method.h"

namespace etendue {

/// Which steps are to be taken from t = 0 on.
struct StepPlan {
  StepMethod method = StepMethod::sdirk2;
  double until = 0;  ///< [time]
  double step = 0;   ///< [time], at most
  /// Relative error of a step, to which steps adapt. 0: they are even. Not with bdf2.
  double tolerance = 0;
  /// Rising times in (0, until) at which a step ends.
  std::vector<double> stops = {};

  bool accepts(double error) const { return tolerance == 0 || error <= tolerance; }
};

/// Steps that differ by less are alike, relative to their length.
inline constexpr double alike_steps = 1e-9;

/// Takes a step from `begin` to `end`, which is `length` later but for rounding, and returns its error: of
/// second order in the length. Where the plan does not accept that, all is to be left as it was. Empty: no
/// more steps are wanted.
using StepTaker = std::function<std::optional<double>(double begin, double length, double end)>;

/// Takes the steps. Throws std::invalid_argument where the plan makes no sense, and std::domain_error where
/// steps that adapt become too short.
void take_all_steps(const StepPlan& plan, const StepTaker& take);

}  // namespace etendue
