// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/photon_map/keep_hits.h"

#include <algorithm>
#include <cmath>

#include "base/parallel/parallel_for.h"
#include "solver/photons/solve/photon_batch.h"

namespace etendue {
namespace {

// Histories of a batch: few, where few hits are wanted. And batches that are walked before any is kept.
constexpr double largest_batch = 8192, smallest_batch = 64, batches_of_a_map = 64;
constexpr std::size_t batches_of_a_round = 8;
// Of nanoflann's tree: a number for each hit and two nodes of 40 bytes for each leaf of 16, rounded up.
constexpr std::size_t tree_bytes_of_a_hit = 12;

/// Of a history on walls and in media: 2.1 in cases/caustic, whose walls absorb half.
constexpr double usual_hits = 2;

/// Grows while it has room: whole batches alone, so that all histories count the same.
class Growing {
 public:
  Growing(double most, KeptHits& kept) : most_(most), kept_(kept) {}
  bool full() const { return full_; }
  void add(const std::vector<PhotonHit>& hits, std::size_t histories) {
    if (full_) return;
    const auto now = static_cast<double>(kept_.hits.size() + hits.size());
    full_ = now > most_;
    if (full_ && kept_.histories > 0) return;
    kept_.hits.insert(kept_.hits.end(), hits.begin(), hits.end());
    kept_.histories += static_cast<double>(histories);
  }

 private:
  double most_;
  KeptHits& kept_;
  bool full_ = false;
};

}  // namespace

std::vector<BandHits> keep_hits(const Problem& problem, const CellLocator& locator,
                                const PhotonMapOptions& options, const std::function<bool()>& go_on) {
  const PhotonBatches batches(problem, locator, options.seed);
  std::vector<BandHits> bands(static_cast<std::size_t>(problem.band_count()));
  const auto all = static_cast<std::size_t>(options.photons);
  const auto batch =
      static_cast<std::size_t>(std::clamp(options.hits / batches_of_a_map, smallest_batch, largest_batch));
  StageCounter counter(all * bands.size(), [&](double) { return !go_on || go_on(); });
  for (int b = 0; b < problem.band_count() && !counter.stopped(); ++b) {
    BandHits& band = bands[static_cast<std::size_t>(b)];
    Growing walls(options.hits, band.walls), matter(options.hits, band.matter);
    for (std::size_t done = 0; done < all && !(walls.full() && matter.full());) {
      const std::size_t rest = all - done, count = std::min(batches_of_a_round, (rest + batch - 1) / batch);
      std::vector<PhotonBatches::Hits> round(count);
      const auto size_of = [&](std::size_t i) { return std::min(batch, rest - i * batch); };
      parallel_for(count, options.threads, 1, [&](std::size_t i) {
        round[i] = batches.hits(b, done + i * batch, size_of(i), counter);
        return !counter.stopped();
      });
      if (counter.stopped()) break;
      for (std::size_t i = 0; i < count; ++i) {
        walls.add(round[i].walls, size_of(i));
        matter.add(round[i].matter, size_of(i));
        done += size_of(i);
      }
    }
    for (KeptHits* kept : {&band.walls, &band.matter})
      kept->power = kept->histories > 0 ? batches.power(b) / kept->histories : 0;
  }
  return bands;
}

HitMemory estimate_hit_memory(const Problem& problem, const PhotonMapOptions& options) {
  const auto positive = [](double k) { return k > 0; };
  const bool has_media = std::ranges::any_of(problem.absorption(), positive) ||
                         std::ranges::any_of(problem.scattering(), positive);
  // The hits of one band are copied when their place grows.
  const auto bytes_of = [&](double hits) {
    const double all = (has_media ? 2 : 1) * hits * problem.band_count();
    return static_cast<std::size_t>(all * (sizeof(PhotonHit) + tree_bytes_of_a_hit) +
                                    hits * sizeof(PhotonHit));
  };
  return {bytes_of(options.hits), bytes_of(std::min(options.hits, usual_hits * options.photons))};
}

}  // namespace etendue
