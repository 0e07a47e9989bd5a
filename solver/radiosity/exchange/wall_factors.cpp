// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/exchange/wall_factors.h"

namespace etendue {

// Irradiance everywhere where one wall sends 1 and the others nothing: a column for each wall.
std::vector<double> factors_of_walls(const Exchange& exchange, const WallPatches& patches,
                                     std::size_t walls) {
  const std::size_t count = exchange.size();
  std::vector<double> sent(count * walls, 0), area(walls, 0), factors(walls * walls, 0);
  for (std::size_t p = 0; p < count; ++p) {
    const auto wall = static_cast<std::size_t>(patches.walls[p]);
    sent[p * walls + wall] = 1;
    area[wall] += patches.patches[p].area();
  }
  const std::vector<double> arrived = exchange.times(sent, walls);
  for (std::size_t p = 0; p < count; ++p) {
    const auto a = static_cast<std::size_t>(patches.walls[p]);
    for (std::size_t b = 0; b < walls; ++b) factors[a * walls + b] += arrived[p * walls + b] / area[a];
  }
  return factors;
}

}  // namespace etendue
