// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "solver/angular/sets/direction_set.h"
#include "solver/solution/solution.h"
#include "solver/solution/solve_observer.h"
#include "solver/solution/solve_options.h"
#include "solver/time/uncollided_in_time.h"

namespace etendue {

/// Takes moment k of the light after a pulse of all sources while it lasts; `uncollided` is null, or what the
/// moment has beside the solution.
using MomentReader = std::function<void(int k, const Problem& problem, const Solution& moment,
                                        const UncollidedValues* uncollided)>;

/// The moments M_k, the integral of t^k u over time, k = 0 … `highest`: (-1)^k times the derivatives of the
/// transform at s = 0, (L6) and (L7) of docs/theory/time.md,
///
///     w.grad M_k + sigma_t M_k = integral of sigma_s p(w.w') M_k(w') dw' + k n/c M_(k-1),
///
/// M_0 being the steady light. M_1 / M_0 is the mean time of flight, M_2 / M_0 less its square the variance.
/// Each is one more solution with the same coefficients; the radiance of one is kept for all directions.
/// Options and `uncollided` as in march_in_time(). Throws as solve() does.
void solve_flight_moments(const Problem& problem, const DirectionSet& directions, const Slowness& slowness,
                          int highest, const SolveOptions& options, const MomentReader& reader,
                          const SolveObserver& observer = {}, const UncollidedInTime* uncollided = nullptr);

}  // namespace etendue
