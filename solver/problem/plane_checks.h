// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/problem/problem.h"

namespace etendue {

/// Faults of the walls of a plane problem: those that face along z must be cold mirrors, since nothing may
/// depend on z and no direction reaches them; all others must stand upright.
void check_plane_walls(const Problem& problem, std::vector<Fault>& faults);

}  // namespace etendue
