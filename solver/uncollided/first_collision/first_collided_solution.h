// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/solution/direction_set_solution.h"
#include "solver/solution/solution.h"
#include "solver/solution/solve_options.h"
#include "solver/uncollided/first_collision/first_collision.h"

namespace etendue {

/// First-collided light, scattered or diffusely reflected once, solved on its own set of directions,
///
///     w.grad u_1 + sigma_t u_1 = S u_0,
///
/// and handed on to the rest, u = u_0 + u_1 + u_2,
///
///     w.grad u_2 + sigma_t u_2 = S (u_1 + u_2) + q,
///
/// which takes a coarser set: what still shows rays is light scattered twice (Hauck and McClarren 2013 split
/// so by collisions). Both equations conserve, so their sum does.
class FirstCollidedSolution : public AngularInput {
 public:
  /// `remaining` is LightSetup::remaining(), `directions` the set of the rest. `field` and `finer` must
  /// outlive it. Where the options keep the radiance of all ordinates, so does it. Throws InputError where
  /// that scatters by a matrix or the finer set has other moments.
  FirstCollidedSolution(const LightSetup& lights, const UncollidedField& field, const Problem& remaining,
                        const DirectionSet& finer, const DirectionSet& directions,
                        const SolveOptions& options, int threads);

  bool depends_on_direction(CellIndex cell) const override { return input_->depends_on_direction(cell); }
  void add_source(OrdinateIndex, CellIndex, std::span<double>) const override {}
  void add_inflow(OrdinateIndex, FaceIndex, std::span<double>) const override {}
  const SavedState* prescribed_state() const override { return &solution_.state; }

  /// As it was swept, to be read beside the rest.
  DirectionSetSolution swept() const { return {finer_, solution_, &*input_}; }
  /// Adds to the solution of the rest what its state does not hold.
  void add_to(Solution& rest) const;
  /// Upper estimate of the bytes that are kept beside the solution of the rest and FirstCollision.
  static std::size_t memory(const Problem& problem, const DirectionSet& directions, const DirectionSet& finer,
                            const SolveOptions& options);

 private:
  void sweep(const Problem& problem, const SolveOptions& options);

  const DirectionSet& finer_;
  std::optional<FirstCollision> input_;  ///< empty while the options are checked
  Solution solution_;
  int sweeps_ = 0;
  double seconds_ = 0;  ///< of the first collisions
};

}  // namespace etendue
