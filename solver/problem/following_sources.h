// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/problem/cell_emission.h"

namespace etendue {

/// What media and walls emit whose temperature follows from the light itself, beside what the problem says.
struct FollowingSources {
  CellEmission cells;            ///< empty: none
  std::vector<double> radiance;  ///< [boundary face][3][band] of walls [power/(length^2 sr)]; empty: none

  bool empty() const { return cells.empty() && radiance.empty(); }
};

}  // namespace etendue
