// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/camera/picture.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "base/parallel/parallel_for.h"
#include "solver/observe/camera/gather.h"

namespace etendue {
namespace {

/// One pixel: rays through the middles of equal squares.
void add_rays(const RayLook& look, const Camera& camera, const CameraRays& rays, int column, int row,
              std::span<double> pixel) {
  const int side = static_cast<int>(std::lround(std::sqrt(camera.samples)));
  std::vector<double> radiance(pixel.size());
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const double across = column + (i + 0.5) / side, down = row + (j + 0.5) / side;
      if (!rays.shows(across, down)) continue;
      std::fill(radiance.begin(), radiance.end(), 0.0);
      look(rays.through(across, down), radiance);
      for (std::size_t b = 0; b < pixel.size(); ++b) pixel[b] += radiance[b] / (side * side);
    }
}

/// A step of about the golden section of all rows that comes to each of them.
std::size_t step_between_rows(std::size_t rows) {
  constexpr double golden = 0.6180339887498949;
  auto step = static_cast<std::size_t>(golden * static_cast<double>(rows)) + 1;
  while (std::gcd(step, rows) != 1) ++step;
  return step;
}

}  // namespace

Picture take_picture(std::size_t bands, const std::function<RayLook()>& make_look, const Camera& camera,
                     int threads, const StageObserver& observer) {
  const CameraRays rays(camera);
  const int columns = camera.pixels[0], lines = camera.pixels[1];
  Picture picture{camera.pixels, bands, {}};
  picture.radiance.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(lines) * bands, 0);
  StageCounter counter(static_cast<std::size_t>(columns) * static_cast<std::size_t>(lines), observer);
  // Rows far from one another come one after the other, so that the share that is done tells the time.
  const std::size_t step = step_between_rows(static_cast<std::size_t>(lines));
  const auto take_row = [&](std::size_t i, const RayLook& look) {
    const std::size_t row = i * step % static_cast<std::size_t>(lines);
    for (int column = 0; column < columns && !counter.stopped(); ++column) {
      add_rays(
          look, camera, rays, column, static_cast<int>(row),
          std::span(picture.radiance)
              .subspan((row * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)) * bands,
                       bands));
      counter.add();
    }
    return !counter.stopped();
  };
  picture.whole = parallel_for(static_cast<std::size_t>(lines), threads, 1, make_look, take_row);
  return picture;
}

Picture take_picture(const RayRadiance& scene, const Camera& camera, int threads,
                     const StageObserver& observer, const StageObserver& gathering) {
  const WallIrradiance gathered = gather(scene, camera.gather, camera.shadow_rays, threads, gathering);
  if (camera.gather > 0 && gathered.values.empty()) return {camera.pixels, scene.bands(), {}, false};
  const RayView view{.shafts = camera.shafts,
                     .brought = camera.gather > 0 ? &gathered : nullptr,
                     .glossy = camera.glossy,
                     .shadow_rays = camera.shadow_rays};
  const auto make_look = [&]() -> RayLook {
    return [&, work = std::make_shared<RayRadiance::Workspace>(scene)](const CameraRay& ray,
                                                                       std::span<double> radiance) {
      if (const auto start = scene.enter(ray.origin, ray.direction))
        scene.along(*start, ray.direction, view, *work, radiance);
    };
  };
  return take_picture(scene.bands(), make_look, camera, threads, observer);
}

}  // namespace etendue
