// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "solver/lights/light_setup.h"
#include "solver/ordinates/solve.h"

namespace etendue {

/// Looks at what solve() found on each set of directions that a run sweeps, before light that was found along
/// rays is added and means over rotated sets are taken. The last argument is the angular input of that sweep,
/// null without one.
using SetReader = std::function<void(const DirectionSet&, const Solution&, const AngularInput*)>;

/// The light of a problem that has not collided yet, by rays: found once, whatever directions the rest is
/// solved on.
class UncollidedLight {
 public:
  /// `lights` must outlive it.
  UncollidedLight(const LightSetup& lights, const SolveOptions& options);

  /// The rest by discrete ordinates, with the first collisions as a source, and both together. Light that
  /// collides once is swept on the directions `first_collided` where that is not null. Without lights this is
  /// solve(). The options must not have an angular input of their own.
  Solution solve_rest(const DirectionSet& directions, const DirectionSet* first_collided,
                      const SolveOptions& options, const SolveObserver& observer,
                      const SetReader& reader = {}) const;
  const LightSetup& lights() const { return lights_; }
  /// Hands the uncollided part over to a solution.
  void finish(Solution& solution) &&;

 private:
  Solution sweep_rest(const DirectionSet& directions, const DirectionSet* first_collided,
                      const SolveOptions& options, const SolveObserver& observer,
                      const SetReader& reader) const;

  const LightSetup& lights_;
  int threads_;
  UncollidedField field_;
  double seconds_ = 0;
};

/// Solves a problem as the sum of the light that has not collided yet, by rays, and the rest, by discrete
/// ordinates with the first collisions as a source. Without lights this is solve(). The options must not have
/// an angular input of their own. `first_collided` as in UncollidedLight::solve_rest().
Solution solve_split(const LightSetup& lights, const DirectionSet& directions, const SolveOptions& options,
                     const SolveObserver& observer = {}, const DirectionSet* first_collided = nullptr,
                     const SetReader& reader = {});

/// Bytes that solve_split() may take at its peak: an upper estimate.
std::size_t estimate_split_memory(const LightSetup& lights, const DirectionSet& directions,
                                  const SolveOptions& options, const DirectionSet* first_collided = nullptr);

}  // namespace etendue
