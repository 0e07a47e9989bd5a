// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/sensors/wall_intensity.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/parallel/parallel_for.h"
#include "mesh/tetrahedra/corners.h"
#include "solver/uncollided/sources/point_source.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// A beam goes along a direction where the two differ by less.
constexpr double beam_along_direction = 1e-9;

struct WallPoint {
  PointInCell place;
  Vec3 area;  ///< out of the domain, that the point represents
};

std::vector<WallPoint> points_of(const TetrahedralMesh& mesh, int wall) {
  std::vector<WallPoint> points;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    if (mesh.wall(face) != wall) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      Vec3 point = Vec3::Zero();
      for (std::size_t k = 0; k < 3; ++k) point += (k == i ? 2. / 3 : 1. / 6) * corner_of(mesh, face, k);
      points.push_back({{mesh.owner(face), point}, mesh.area_normal(face) / 3});
    }
  }
  return points;
}

struct PointLightPlace {
  const PointSource* source;
  PointInCell place;
};

std::vector<PointLightPlace> point_lights(const LightSetup& lights) {
  std::vector<PointLightPlace> places;
  const CellLocator locator(lights.problem().mesh());
  for (const auto& source : lights.sources())
    if (const PointSource* point = source->as_point())
      places.push_back({point, {locator.find(point->position()).front().cell, point->position()}});
  return places;
}

/// Adds what a point sends straight out by the wall in a direction: the fluence where it goes out times the
/// distance squared.
void add_point_light(const LightSetup& lights, const PointLightPlace& light, int wall, const Vec3& direction,
                     std::span<double> intensity) {
  const RayEnd end =
      lights.paths().rays().walk(light.place.cell, light.place.position, direction,
                                 std::numeric_limits<double>::infinity(), [](CellIndex, double) {});
  if (lights.problem().mesh().wall(*end.wall) != wall) return;
  LightBeams beams(intensity.size());
  light.source->add_beams({end.cell, end.point}, Sight::attenuated, fine_light, beams);
  const double square = (end.point - light.place.position).squaredNorm();
  for (std::size_t i = 0; i < beams.size(); ++i)
    for (std::size_t b = 0;
         b < intensity.size() && (beams.direction(i) - direction).norm() < beam_along_direction; ++b)
      intensity[b] += beams.fluence(i)[b] * square;
}

}  // namespace

WallFrame::WallFrame(const TetrahedralMesh& mesh, int wall) {
  Vec3 sum = Vec3::Zero();
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    if (mesh.wall(FaceIndex(f)) == wall) sum += mesh.area_normal(FaceIndex(f));
  axis = sum.normalized();
  constexpr double along_x = 0.99;
  const Vec3 reference = std::abs(axis.x()) > along_x ? Vec3::UnitY() : Vec3::UnitX();
  across = (reference - reference.dot(axis) * axis).normalized();
  up = axis.cross(across);
}

Vec3 WallFrame::direction(double polar, double azimuth) const {
  return std::cos(polar) * axis + std::sin(polar) * (std::cos(azimuth) * across + std::sin(azimuth) * up);
}

double polar_angle(int k, int count) { return count > 1 ? pi / 2 * k / (count - 1) : 0; }
double azimuth_angle(int k, int count) { return 2 * pi * k / count; }

GridReading wall_intensity(const LightSetup& lights, const RayRadiance& scene, int wall, int azimuths,
                           int polar_angles, int threads, StageCounter* counter) {
  const TetrahedralMesh& mesh = lights.problem().mesh();
  const WallFrame frame(mesh, wall);
  const std::vector<WallPoint> points = points_of(mesh, wall);
  const std::vector<PointLightPlace> bulbs = point_lights(lights);
  const std::size_t bands = scene.bands();
  const auto count = static_cast<std::size_t>(azimuths) * static_cast<std::size_t>(polar_angles);
  GridReading reading{std::vector<double>(count * bands, 0), std::vector<double>(count * bands, 0)};
  const auto look = [&](std::size_t i, RayRadiance::Workspace& work) {
    const auto columns = static_cast<std::size_t>(azimuths);
    const Vec3 direction = frame.direction(polar_angle(static_cast<int>(i / columns), polar_angles),
                                           azimuth_angle(static_cast<int>(i % columns), azimuths));
    const std::span uncollided = std::span(reading.uncollided).subspan(i * bands, bands);
    std::vector<double> other(bands), all(bands);
    for (const WallPoint& point : points) {
      if (counter != nullptr && !counter->add()) return false;
      const double across = point.area.dot(direction);
      // Along the wall nothing leaves; rounding must not make rays run in it.
      if (across <= 1e-12 * point.area.norm()) continue;
      scene.along(point.place, -direction, {.lights_shown = false}, work, other);
      if (!lights.empty()) scene.along(point.place, -direction, {.lights_shown = true}, work, all);
      for (std::size_t b = 0; b < bands; ++b) {
        reading.collided[i * bands + b] += across * other[b];
        if (!lights.empty()) uncollided[b] += across * (all[b] - other[b]);
      }
    }
    for (const PointLightPlace& bulb : bulbs) add_point_light(lights, bulb, wall, direction, uncollided);
    return true;
  };
  parallel_for(
      count, threads, 1, [&] { return RayRadiance::Workspace(scene); }, look);
  return reading;
}

std::size_t intensity_rays(const TetrahedralMesh& mesh, int wall, std::size_t directions) {
  return directions * points_of(mesh, wall).size();
}

}  // namespace etendue
