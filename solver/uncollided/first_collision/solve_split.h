// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include "solver/angular/sets/direction_set.h"
#include "solver/solution/direction_set_solution.h"
#include "solver/solution/solution.h"
#include "solver/solution/solve_observer.h"
#include "solver/solution/solve_options.h"
#include "solver/transport/solve/solve.h"
#include "solver/uncollided/first_collision/first_collisions.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// The light of a problem that has not collided yet, by rays: found once, whatever directions the rest is
/// solved on.
class UncollidedLight {
 public:
  /// `lights` must outlive it. The observer must not stop the rays.
  UncollidedLight(const LightSetup& lights, const SolveOptions& options, const StageObserver& observer = {});

  /// The rest by discrete ordinates, with the first collisions as a source, and both together. Light that
  /// collides once is swept on the directions `first_collided` where that is not null; its radiance is kept
  /// for the reader where the options keep that of all ordinates. Without lights this is solve(). The options
  /// must not have an angular input of their own.
  Solution solve_rest(const DirectionSet& directions, const DirectionSet* first_collided,
                      const SolveOptions& options, const SolveObserver& observer,
                      const DirectionSetObserver& reader = {}) const;
  /// Adds the uncollided part to a solution of the rest, of a setup with lights.
  void complete(Solution& solution, const SolveOptions& options) const;
  const LightSetup& lights() const { return lights_; }
  /// Of all sources; until finish().
  const UncollidedField& field() const { return field_; }
  /// Hands the uncollided part over to a solution. Of the field only first_collisions() are left.
  void finish(Solution& solution);
  /// After finish(): for pictures and sensors of the same problem.
  std::shared_ptr<const FirstCollisions> first_collisions() const { return first_collisions_; }

 private:
  Solution sweep_rest(const DirectionSet& directions, const DirectionSet* first_collided,
                      const SolveOptions& options, const SolveObserver& observer,
                      const DirectionSetObserver& reader) const;

  const LightSetup& lights_;
  int threads_;
  UncollidedField field_;
  std::shared_ptr<const FirstCollisions> first_collisions_;
  double seconds_ = 0;
};

/// Solves a problem as the sum of the light that has not collided yet, by rays, and the rest, by discrete
/// ordinates with the first collisions as a source. Without lights this is solve(). The options must not have
/// an angular input of their own. `first_collided` as in UncollidedLight::solve_rest().
Solution solve_split(const LightSetup& lights, const DirectionSet& directions, const SolveOptions& options,
                     const SolveObserver& observer = {}, const DirectionSet* first_collided = nullptr,
                     const DirectionSetObserver& reader = {});

/// Bytes that solve_split() takes at its peak.
std::size_t estimate_split_memory(const LightSetup& lights, const DirectionSet& directions,
                                  const SolveOptions& options, const DirectionSet* first_collided = nullptr,
                                  KrylovVectors vectors = KrylovVectors::all);

}  // namespace etendue
