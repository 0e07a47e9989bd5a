// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/problem/problem.h"
#include "solver/solution/solution.h"

namespace etendue {

/// The field at one point and band.
struct ProbeValue {
  double fluence = 0;                ///< [power/length^2]
  std::array<double, 3> net_flux{};  ///< [power/length^2]
};

/// Values at a point: where it lies in several cells their volume-weighted mean. Empty outside the mesh.
std::vector<ProbeValue> probe(const Problem& problem, const Solution& solution, const CellLocator& locator,
                              const Vec3& point);  ///< [band]

/// The same of the uncollided light that the solution holds, as it is projected on the cells.
std::vector<ProbeValue> probe_uncollided(const Problem& problem, const Solution& solution,
                                         const CellLocator& locator, const Vec3& point);  ///< [band]

}  // namespace etendue
