// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/photon_map/map_picture.h"

#include <memory>

namespace etendue {

Picture take_picture(const MapRadiance& map, const Camera& camera, int threads,
                     const StageObserver& observer) {
  const RayEntry entry(map.problem().mesh());
  const auto make_look = [&]() -> RayLook {
    return [&, work = std::make_shared<MapRadiance::Workspace>()](const CameraRay& ray,
                                                                  std::span<double> radiance) {
      const auto start = entry.enter(ray.origin, ray.direction);
      for (std::size_t b = 0; start && b < radiance.size(); ++b)
        radiance[b] = map.along(*start, ray.direction, static_cast<int>(b), *work);
    };
  };
  return take_picture(static_cast<std::size_t>(map.problem().band_count()), make_look, camera, threads,
                      observer);
}

}  // namespace etendue
