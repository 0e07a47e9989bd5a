// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/problem/problem.h"
#include "solver/solution/solution.h"

namespace etendue {

/// Powers of one band; emitted + inflow = absorbed + outflow for a converged solution.
struct Balance {
  double emitted = 0;   ///< by the media
  double inflow = 0;    ///< emitted by walls, not what they reflect, and by lights
  double absorbed = 0;  ///< in the media
  double outflow = 0;   ///< what walls keep: incoming - reflected
  double residual = 0;  ///< (emitted + inflow - absorbed - outflow) / (emitted + inflow); 0 if nothing emits
};

/// Powers of one wall and band, seen from the wall.
struct WallPower {
  double area = 0;             ///< [length^2]
  double irradiance_mean = 0;  ///< [power/length^2]
  double incoming = 0;         ///< arriving from the domain
  double outgoing = 0;         ///< sent into the domain: emitted + reflected
  double emitted = 0;          ///< by the discrete half range, L pi_h A, or by rays
  double emitted_exact = 0;    ///< pi L A, and beams; 2 L A in the plane; what depends on the
                               ///< direction as it is emitted
};

/// Totals of one region and band.
struct RegionPower {
  double volume = 0;        ///< [length^3]
  double fluence_mean = 0;  ///< [power/length^2]
  double absorbed = 0;
  double emitted = 0;
};

std::vector<Balance> balances(const Problem& problem, const Solution& solution);  ///< [band]
std::vector<std::vector<WallPower>> wall_powers(const Problem& problem,
                                                const Solution& solution);  ///< [wall][band]
std::vector<std::vector<RegionPower>> region_powers(const Problem& problem,
                                                    const Solution& solution);  ///< [region][band]

}  // namespace etendue
