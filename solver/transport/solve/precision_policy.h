// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/problem/problem.h"
#include "solver/solution/solve_options.h"

namespace etendue {

/// Whether the cycles of GMRES, of a problem that needs some, sweep in single precision.
bool has_cycles_in_single_precision(const Problem& problem, const SolveOptions& options);

}  // namespace etendue
