// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>

#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/solution/direction_set_solution.h"
#include "solver/solution/solution.h"
#include "solver/solution/solve_observer.h"
#include "solver/solution/solve_options.h"
#include "solver/transport/solve/transport_solver.h"
#include "solver/uncollided/first_collision/first_collision.h"
#include "solver/uncollided/first_collision/solve_split.h"

namespace etendue {

/// UncollidedLight::solve_rest() again and again, of a problem whose emission follows from the light
/// (SolveOptions::following_emission) by rules that change: what does not depend on it is made once.
class RepeatedSolver {
 public:
  /// The arguments must outlive it. The options must not have an angular input of their own.
  RepeatedSolver(const UncollidedLight& uncollided, const DirectionSet& directions,
                 const SolveOptions& options);

  /// Swept and uncollided light. Throws as solve() does.
  Solution solve(const SolveObserver& observer = {});
  /// Keeps the swept part of the last solution for read().
  void keep() { kept_ = std::move(swept_); }
  void read(const DirectionSetObserver& reader) const;

 private:
  const UncollidedLight& uncollided_;
  const DirectionSet& directions_;
  Problem remaining_;
  std::optional<FirstCollision> input_;  ///< none without lights
  SolveOptions options_;
  TransportSolver solver_;
  Solution swept_, kept_;
};

}  // namespace etendue
