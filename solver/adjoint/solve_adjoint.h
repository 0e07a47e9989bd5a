// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/adjoint/emitter_source.h"
#include "solver/adjoint/response.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/solution/solution.h"
#include "solver/solution/solve_observer.h"
#include "solver/solution/solve_options.h"

namespace etendue {

/// What one emitter brings of a response, in the response's unit.
struct EmitterShare {
  EmitterKind kind;
  std::string name;
  std::vector<double> uncollided;  ///< [band] along rays, before the first collision; 0 where it has no rays
  std::vector<double> swept;       ///< [band] all the rest, by the importance
};

/// The importance of all places and directions for one response.
struct AdjointSolution {
  /// The solution v(w) = u+(-w) of reversed_problem(). Its fluence over 4 pi is the response that one unit of
  /// power brings which is emitted there alike in all directions, its irradiance at a wall over pi that of
  /// one unit that the wall emits there.
  Solution importance;
  std::vector<EmitterShare> shares;

  /// [band] the sum of all shares: what a run reads
  std::vector<double> response() const;
};

/// Throws InputError as reversed_problem() does, and where what is absorbed in a region depends on the
/// direction.
void check_adjoint(const Problem& problem, const Response& response, const SolveOptions& options);

/// Solves for the importance of a response, once, and finds by it what every emitter brings,
///
///     <r, u> = <r, u_0> + <q + S u_0, u+>,
///
/// with u_0 the uncollided light of those that are followed along rays (Bell and Glasstone 1970, chapter 6).
/// The discrete operators are adjoint to each other, so the sum is the response of a run on the same sets to
/// the iteration's tolerance. Of several sets the mean is taken. Options as of a run; meters, ordinates
/// to keep and a state to start from are not used. Throws InputError as check_adjoint() does.
/// Throws SolveStopped.
AdjointSolution solve_adjoint(const std::vector<std::unique_ptr<const EmitterSource>>& emitters,
                              const Problem& problem, const std::vector<DirectionSet>& sets,
                              const Response& response, const SolveOptions& options,
                              const SolveObserver& observer = {});

/// Follows the light of each emitter of a problem along rays.
std::vector<std::unique_ptr<const EmitterSource>> emitter_sources(const Problem& problem, int threads,
                                                                  const StageObserver& observer = {});

}  // namespace etendue
