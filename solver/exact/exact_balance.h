// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/exact/exact_input.h"
#include "solver/solution/balance.h"

namespace etendue {

/// Adds the power of the exact source to the regions and the balances, and the inflow at the walls, which
/// are black, to the balances. The source may take power away.
void add_exact_powers(const ExactInput& input, const std::vector<std::vector<WallPower>>& walls,
                      std::vector<std::vector<RegionPower>>& regions, std::vector<Balance>& balances);

}  // namespace etendue
