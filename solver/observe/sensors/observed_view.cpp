// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/sensors/observed_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel/parallel_for.h"
#include "solver/observe/camera/camera.h"
#include "solver/uncollided/sources/point_source.h"

namespace etendue {
namespace {

using std::numbers::pi;

CameraRays fisheye_of(const Sensor& sensor) {
  Camera camera;
  camera.position = sensor.position;
  camera.look_at = sensor.position + sensor.direction;
  camera.up = sensor.up;
  camera.projection = Projection::fisheye;
  camera.field_of_view = 180;
  camera.pixels = {sensor.count[0], sensor.count[0]};
  return CameraRays(camera);
}

/// Calls found(row, column) for each pixel whose middle lies in the circle.
template <class Found>
void for_each_pixel(const CameraRays& rays, int across, const Found& found) {
  for (int row = 0; row < across; ++row)
    for (int column = 0; column < across; ++column)
      if (rays.shows(column + 0.5, row + 0.5)) found(row, column);
}

// At the angle theta from the view, theta being pi/across of each pixel: d omega = sin(theta)/theta dA.
double solid_angle_at(double angle, int across) {
  const double step = pi / across;
  return step * step * (angle > 0 ? std::sin(angle) / angle : 1);
}

/// A beam comes from an image of a point where the two differ by less.
constexpr double beam_from_image = 1e-9;

/// Path length from a place to that image of a point light, itself or in mirrors, which is in a direction.
double path_length(const PointSource& point, const Vec3& place, const Vec3& towards) {
  for (const PointSource::Image& image : point.images()) {
    const Vec3 path = image.position - place;
    if ((path.normalized() - towards).norm() < beam_from_image) return path.norm();
  }
  return 0;
}

/// Light that no pixel shows.
void add_beams(const LightSetup& lights, const PointInCell& place, const Sensor& sensor, ObservedView& view) {
  LightBeams beams(lights.paths().bands());
  for (const auto& source : lights.sources()) {
    if (source->as_wide() != nullptr) continue;
    beams.clear();
    source->add_beams(place, Sight::attenuated, fine_light, beams);
    for (std::size_t k = 0; k < beams.size(); ++k) {
      const Vec3 towards = -beams.direction(k);
      if (sensor.direction.dot(towards) <= 0) continue;
      const PointSource* point = source->as_point();
      view.beams.push_back({towards,
                            {beams.fluence(k).begin(), beams.fluence(k).end()},
                            point != nullptr ? path_length(*point, place.position, towards) : 0});
    }
  }
}

}  // namespace

std::size_t rays_of_view(const Sensor& sensor) {
  std::size_t count = 0;
  for_each_pixel(fisheye_of(sensor), sensor.count[0], [&](int, int) { ++count; });
  return count;
}

ObservedView observe_view(const LightSetup& lights, const RayRadiance& scene, const PointInCell& place,
                          const Sensor& sensor, int threads, StageCounter& counter) {
  const int across = sensor.count[0];
  const std::size_t bands = scene.bands();
  const auto pixels = static_cast<std::size_t>(across) * static_cast<std::size_t>(across);
  ObservedView view{across,
                    std::vector<Vec3>(pixels, Vec3::Zero()),
                    std::vector<double>(pixels, 0),
                    std::vector<double>(pixels * bands, 0),
                    std::vector<double>(pixels * bands, 0),
                    {}};
  const CameraRays rays = fisheye_of(sensor);
  std::vector<std::size_t> seen;
  for_each_pixel(rays, across, [&](int row, int column) {
    const auto at =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(across) + static_cast<std::size_t>(column);
    view.directions[at] = rays.through(column + 0.5, row + 0.5).direction;
    const double cosine = std::min(1.0, view.directions[at].dot(sensor.direction));
    view.solid_angle[at] = solid_angle_at(std::acos(cosine), across);
    seen.push_back(at);
  });
  parallel_for(
      seen.size(), threads, static_cast<std::size_t>(across), [&] { return RayRadiance::Workspace(scene); },
      [&](std::size_t i, RayRadiance::Workspace& work) {
        const std::size_t at = seen[i];
        const std::span collided = std::span(view.collided).subspan(at * bands, bands);
        const std::span uncollided = std::span(view.uncollided).subspan(at * bands, bands);
        RayView look{.lights_shown = false, .shadow_rays = quick_shadow_rays};
        scene.along(place, view.directions[at], look, work, collided);
        if (!lights.empty()) {
          look.lights_shown = true;
          scene.along(place, view.directions[at], look, work, uncollided);
          for (std::size_t b = 0; b < bands; ++b) uncollided[b] -= collided[b];
        }
        return counter.add();
      });
  add_beams(lights, place, sensor, view);
  return view;
}

}  // namespace etendue
