// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "app/case/build/entry_of.h"
#include "app/case/case.h"
#include "app/setup/run_options.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/solution/solve_options.h"
#include "solver/time/laplace_problem.h"

namespace etendue {

/// A case and what its steady solution has been made with.
struct TimeSetup {
  const Case& input;
  const Problem& problem;
  const std::vector<DirectionSet>& sets;
  const SolveOptions& options;
  const CellLocator& locator;
  bool follows_rays = false;  ///< whether the steady solution has light along rays
};

/// Slowness of light in each region [time/length].
inline Slowness slowness_of(const Case& input, const Problem& problem) {
  Slowness slowness;
  for (const std::string& region : problem.mesh().region_names())
    slowness.push_back(entry_of(input.media, region).refractive_index / input.time->speed);
  return slowness;
}

}  // namespace etendue
