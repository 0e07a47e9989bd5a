// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/observe/photon_map/map_radiance.h"

namespace etendue {

inline MapRadiance map_of(const Problem& problem, double photons, std::size_t neighbours) {
  const PhotonMapOptions options{photons, 1e7, neighbours, 1, 2};
  return MapRadiance(problem, keep_hits(problem, CellLocator(problem.mesh()), options), neighbours);
}

/// Differences of estimates from what they should be, in their standard errors.
struct Deviation {
  double mean = 0, rms = 0;
  double error = 0;  ///< mean of the standard errors, relative
};

template <class Estimated>
Deviation deviation(int count, double exact, const Estimated& estimated) {
  Deviation result;
  for (int i = 0; i < count; ++i) {
    const Estimate found = estimated(i);
    // The error of what is exact, since an estimate that is low has a low error too.
    const double relative = found.error / found.value, difference = (found.value / exact - 1) / relative;
    result.mean += difference / count;
    result.rms += difference * difference / count;
    result.error += relative / count;
  }
  result.rms = std::sqrt(result.rms);
  return result;
}

}  // namespace etendue
