// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "app/case/build/entry_of.h"
#include "app/case/case.h"
#include "app/setup/run_options.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"
#include "solver/solution/solve_options.h"
#include "solver/time/slowness.h"
#include "solver/time/uncollided_in_time.h"
#include "solver/uncollided/lights/light_setup.h"

namespace etendue {

/// A case and what its steady solution has been made with.
struct TimeSetup {
  const Case& input;
  const Problem& problem;
  const std::vector<DirectionSet>& sets;
  const SolveOptions& options;
  const CellLocator& locator;
  const LightSetup& lights;
  std::shared_ptr<const UncollidedField> uncollided = nullptr;  ///< of these lights; null in a forecast
};

/// Slowness of light in each region [time/length].
inline Slowness slowness_of(const Case& input, const Problem& problem) {
  Slowness slowness;
  for (const std::string& region : problem.mesh().region_names())
    slowness.push_back(entry_of(input.media, region).refractive_index / *input.time->speed);
  return slowness;
}

/// Bytes of light along rays, with values of so many factors: an estimate.
inline std::size_t memory_of_rays(const TimeSetup& setup, std::size_t factors) {
  return setup.lights.empty() ? 0 : UncollidedInTime::memory(setup.lights, factors);
}

/// Interval about a time over which light after a pulse is averaged.
struct TimeInterval {
  double begin, end;  ///< [time]
};
inline TimeInterval window_about(double t, const TimeCase& time) {
  return {t * (1 - time.window / 2), t * (1 + time.window / 2)};
}

}  // namespace etendue
