// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vec3.h"
#include "solver/problem/problem.h"
#include "solver/solution/solution.h"

namespace etendue {

/// Values of the fluence below zero in one band, at the vertices of cells.
struct NegativeFluence {
  long count = 0;       ///< of 4 values in each cell
  double smallest = 0;  ///< [power/length^2]
  /// The integral of the negative values over that of the fluence, each value standing for a quarter of its
  /// cell.
  double share = 0;
  Vec3 place = Vec3::Zero();  ///< of the smallest [length]
  int region = -1;            ///< in which that is; -1: there is none
};

std::vector<NegativeFluence> negative_fluence(const Problem& problem, const Solution& solution);  ///< [band]

}  // namespace etendue
