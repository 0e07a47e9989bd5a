// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "base/parallel/rank_group.h"
#include "base/parallel/stage_observer.h"
#include "solver/photons/kernel/photon_kernel.h"
#include "solver/photons/solve/photon_mesh.h"
#include "solver/photons/solve/photon_sources.h"
#include "solver/photons/solve/photon_tally.h"

namespace etendue {

/// Weight, relative to that at the start, below which a photon plays roulette; survivors weigh ten times as
/// much.
inline constexpr double roulette = 1e-3;
/// Starts of photons that are made in one call.
inline constexpr std::size_t starts_at_a_time = 4096;

/// Counts the histories of a walk, and ends it where the counter is stopped. The counter must outlive it.
inline WalkWatch watch_by(StageCounter& counter) {
  return {[](void* watcher, std::uint64_t ended) { return static_cast<StageCounter*>(watcher)->add(ended); },
          &counter};
}

/// What all batches of a problem have in common.
class PhotonBatches {
 public:
  /// The arguments must outlive it.
  PhotonBatches(const Problem& problem, const CellLocator& locator, std::uint64_t seed);

  struct Outcome {
    Solution fields;  ///< what this batch alone estimates; none where it was cut short
    PhotonCounts counts;
    double seconds = 0;  ///< of the processor
  };
  /// Walks the histories `first` … `first + count - 1` of every band. Bands share their random numbers: where
  /// they are alike, so is their noise. The counter counts the histories of all bands, and cuts the batch
  /// short where it is stopped. May be called by several threads at a time.
  Outcome walk(std::uint64_t first, std::size_t count, StageCounter& counter) const;
  /// Brings the outcome of a batch, which is whole, from one rank to all.
  void bring(Outcome& outcome, RankGroup& ranks, int from) const;

  /// The same histories of one band by time; adds to the tally. May be called by several threads at a time,
  /// each with a tally of its own.
  void walk_in_time(int band, std::uint64_t first, std::size_t count, const TimedTally& tally,
                    StageCounter& counter) const;

  /// Where the same histories of one band met walls that scatter light, and where they were scattered. None
  /// where the counter was stopped. May be called by several threads at a time.
  struct Hits {
    std::vector<PhotonHit> walls;
    std::vector<PhotonHit> matter;
  };
  Hits hits(int band, std::uint64_t first, std::size_t count, StageCounter& counter) const;

  /// Of draws from kernels, those of all ranks, the part that was beyond what they were taken to be at most.
  double beyond_bounds(RankGroup* ranks) const;
  /// Adds what complete_fields() does not know: emission by formulas.
  void add_emission(Solution& fields) const { input_.emission.add_to(fields); }

  double power(int band) const { return bands_[static_cast<std::size_t>(band)]->sources.power(); }

 private:
  struct Band {
    PhotonMesh mesh;
    PhotonSources sources;
    Band(const Problem& problem, const DirectionalInput& input, const CellLocator& locator, int band)
        : mesh(problem, input, band), sources(problem, mesh, locator, band) {}
  };
  const Problem& problem_;
  std::uint64_t seed_;
  PhotonKernels kernels_;
  DirectionalInput input_;
  std::vector<std::unique_ptr<Band>> bands_;
};

}  // namespace etendue
