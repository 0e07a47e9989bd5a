// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/parallel/stage_observer.h"
#include "solver/adjoint/response.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/solution/solution.h"
#include "solver/solution/solve_options.h"

namespace etendue {

/// The importance of a point leaves it like the light of a lamp, and on directions shows their rays. This
/// puts the exact part of it that has not collided, along rays, in the place of that which the directions
/// sent:
///
///     v -> v + v_0 (rays) - v_0 (directions),
///
/// in the fluence, net flux and irradiance of AdjointSolution::importance. The response becomes a light of
/// the reversed problem: a point with an even or a cosine intensity, a wall or a region that emits, these
/// where they are small (LightSetup). `sets` and `options` are those of the solution. Returns why it was left
/// out, empty where it was not.
std::string follow_uncollided_importance(const Problem& problem, const std::vector<DirectionSet>& sets,
                                         const Response& response, const SolveOptions& options,
                                         Solution& importance, const StageObserver& observer = {});

}  // namespace etendue
