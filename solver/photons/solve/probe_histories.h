// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/parallel/stage_observer.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/problem/problem.h"

namespace etendue {

/// A point at which light is evaluated, and the side of a surface that it may fall on (w.n < 0).
struct PhotonProbe {
  Vec3 point;
  std::optional<Vec3> normal;  ///< unit
};

/// A number and its standard error.
struct Estimate {
  double value = 0;
  double error = 0;
};

struct ProbeEstimate {
  Estimate fluence;                    ///< [power/length^2]
  std::array<Estimate, 3> net_flux;    ///< [power/length^2]
  std::optional<Estimate> irradiance;  ///< [power/length^2] where a normal was given
};

struct ProbeOptions {
  double histories = 2e4;  ///< of each probe and band
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all cores
};

/// Returns whether histories can go back along the light: not where the problem has lights, since backward
/// histories do not meet a point or a beam, nor where a kernel does not claim to be reciprocal.
bool can_walk_back(const Problem& problem);

/// Light at points, without any cell around them that it is averaged over: histories start there and go back
/// along the light, which scatters and is reflected the same way backwards (reciprocity), and collect what
/// media and walls emit. Points must lie in the mesh, and the problem must be one that can_walk_back().
/// [probe][band]; where the observer stops it, probes that are not whole in all bands have no estimates.
std::vector<std::vector<ProbeEstimate>> walk_back_from(const std::vector<PhotonProbe>& probes,
                                                       const Problem& problem, const CellLocator& locator,
                                                       const ProbeOptions& options,
                                                       const StageObserver& observer = {});

}  // namespace etendue
