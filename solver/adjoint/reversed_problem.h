// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/problem/problem.h"
#include "solver/solution/solve_options.h"

namespace etendue {

/// The problem whose solution, read against the directions, is the adjoint one: v(w) = u+(-w) obeys
///
///     w.grad v + sigma_t(-w) v = integral of k(-w -> -w') v(w') dw' + r(-w)
///
/// with the walls of the problem, since their reflection is reciprocal (Bell and Glasstone 1970,
/// section 6.1). Phase functions, leaves and flakes are the same against the directions; nothing emits. The
/// mesh must outlive it. Throws InputError where a medium scatters by a formula or a matrix of both
/// directions, where an emission follows from the light, or where values are kept positive: the response is
/// not linear then, or its adjoint is another problem.
Problem reversed_problem(const Problem& problem, const SolveOptions& options);

}  // namespace etendue
