// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/photons/kernel/photon_scene.h"
#include "solver/problem/problem.h"

namespace etendue {

struct PhotonMapOptions {
  double photons = 1e6;          ///< histories of each band, at most
  double hits = 1e6;             ///< on walls, and as many in media, of each band, at most
  std::size_t neighbours = 100;  ///< of an estimate
  std::uint64_t seed = 1;
  int threads = 1;
};

/// Hits of one band that all bring the same power for the same weight.
struct KeptHits {
  std::vector<PhotonHit> hits;
  double histories = 0;  ///< that they are from
  double power = 0;      ///< of a hit of weight 1
};

/// Where histories of one band met walls and where they were scattered.
struct BandHits {
  KeptHits walls;
  KeptHits matter;
};

/// Hits band by band. Histories are walked, the same as by solve_photons(), until walls and media both have
/// as many hits as wanted, those of 64 histories at least, or until enough histories were walked; where one
/// is full, only the other one grows. The same for any number of threads.
std::vector<BandHits> keep_hits(const Problem& problem, const CellLocator& locator,
                                const PhotonMapOptions& options, const std::function<bool()>& go_on = {});

/// Of the hits and their trees [bytes].
struct HitMemory {
  std::size_t most, expected;
};

HitMemory estimate_hit_memory(const Problem& problem, const PhotonMapOptions& options);

}  // namespace etendue
