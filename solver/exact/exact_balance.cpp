// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/exact/exact_balance.h"

namespace etendue {

void add_exact_powers(const ExactInput& input, const std::vector<std::vector<WallPower>>& walls,
                      std::vector<std::vector<RegionPower>>& regions, std::vector<Balance>& balances) {
  const std::vector<std::vector<double>> sources = input.source_powers();
  for (std::size_t band = 0; band < balances.size(); ++band) {
    Balance& balance = balances[band];
    for (std::size_t region = 0; region < regions.size(); ++region) {
      regions[region][band].emitted += sources[region][band];
      balance.emitted += sources[region][band];
    }
    balance.inflow = balance.outflow = 0;
    for (const std::vector<WallPower>& wall : walls) {
      balance.inflow += wall[band].outgoing;
      balance.outflow += wall[band].incoming;
    }
    const double given = balance.emitted + balance.inflow;
    balance.residual = given > 0 ? (given - balance.absorbed - balance.outflow) / given : 0;
  }
}

}  // namespace etendue
