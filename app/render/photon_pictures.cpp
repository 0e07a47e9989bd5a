// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/render/photon_pictures.h"

#include <fmt/format.h>

#include "app/progress/stage_progress.h"
#include "solver/observe/photon_map/map_picture.h"
#include "solver/photons/sampling/directional_medium.h"

namespace etendue {
namespace {

PhotonMapOptions map_options(const PhotonCase& photons, int threads) {
  return {photons.photons, photons.map_hits, static_cast<std::size_t>(photons.map_neighbours),
          static_cast<std::uint64_t>(photons.seed), threads};
}

std::string kept_text(const Bands& bands, const std::vector<BandHits>& hits) {
  std::string text;
  std::size_t bytes = 0;
  for (std::size_t b = 0; b < hits.size(); ++b) {
    const auto &walls = hits[b].walls, &matter = hits[b].matter;
    text += fmt::format("  {}: {} hits on walls of {:.3g} histories, {} in media of {:.3g}\n", bands.names[b],
                        walls.hits.size(), walls.histories, matter.hits.size(), matter.histories);
    bytes += (walls.hits.size() + matter.hits.size()) * sizeof(PhotonHit);
  }
  return fmt::format("photon map: {:.3g} MiB of hits\n", static_cast<double>(bytes) / (1 << 20)) + text;
}

}  // namespace

void check_photon_cameras(const std::vector<CameraCase>& cameras, const Problem& problem) {
  check_views(cameras, {}, problem);
  std::vector<Fault> faults;
  for (const CameraCase& camera : cameras)
    if (camera.camera.errors)
      faults.push_back(
          fault_at(camera.origin, "",
                   "errors = true asks for the errors of cells and directions, and photons have "
                   "none of these (their picture is known to 1/sqrt(photon_map.neighbours)); remove "
                   "it"));
  if (!cameras.empty() && depends_on_direction(problem))
    faults.push_back(
        fault_at(cameras.front().origin, "",
                 "looks at a medium that depends on the direction, and the photon map does not know "
                 "that (not in this version); use solve.method = \"auto\""));
  if (!faults.empty()) throw InputError(std::move(faults));
}

HitMemory estimate_photon_map_memory(const Case& input, const Problem& problem, int threads) {
  return input.cameras.empty() ? HitMemory{0, 0}
                               : estimate_hit_memory(problem, map_options(*input.photons, threads));
}

bool write_photon_pictures(const PictureOrder& order, const Problem& problem, const CellLocator& locator,
                           int threads) {
  const PhotonMapOptions options = map_options(*order.input.photons, threads);
  std::vector<BandHits> hits;
  {
    const ShownStage stage({order.progress, order.out, order.interrupted}, "photon map");
    hits = keep_hits(problem, locator, options, [&] { return !order.interrupted(); });
  }
  if (order.interrupted()) return false;
  order.out << kept_text(order.input.bands, hits) << std::flush;
  const MapRadiance map(problem, std::move(hits), options.neighbours);
  return write_pictures(
      order,
      [&](const Camera& camera, const StageObserver& observer) {
        return take_picture(map, camera, threads, observer);
      },
      [](NamedPicture&) { return true; });
}

}  // namespace etendue
