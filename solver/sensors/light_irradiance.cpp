// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/sensors/light_irradiance.h"

#include <algorithm>
#include <stdexcept>

#include "solver/lights/sky_source.h"
#include "solver/sensors/polygon_irradiance.h"

namespace etendue {
namespace {

/// Every triangle by itself: points that stand for a group of them may lie beside it, behind an obstacle.
constexpr LightDetail each_triangle{0, 0, fine_light.thickness, fine_light.largest_side, fine_light.rule};

/// Adds the light of beams, on the side that a normal points to and from all sides, times a factor.
void add_beams(const LightBeams& beams, const Vec3& normal, double factor, UncollidedAtPoint& light) {
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const double cosine = std::max(0.0, -normal.dot(beams.direction(i)));
    for (std::size_t b = 0; b < beams.bands(); ++b) {
      light.irradiance[b] += factor * cosine * beams.fluence(i)[b];
      light.fluence[b] += factor * beams.fluence(i)[b];
    }
  }
}

std::vector<std::array<Vec3, 3>> triangles_of_wall(const TetrahedralMesh& mesh, int wall) {
  std::vector<std::array<Vec3, 3>> triangles;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    if (mesh.wall(FaceIndex(f)) != wall) continue;
    std::array<Vec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.point(VertexIndex(mesh.vertices(FaceIndex(f))[i]));
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    if (normal.dot(mesh.area_normal(FaceIndex(f))) > 0) std::swap(corners[1], corners[2]);
    triangles.push_back(corners);
  }
  return triangles;
}

std::vector<std::array<Vec3, 3>> triangles_of(const SurfaceLight& light) {
  std::vector<std::array<Vec3, 3>> triangles;
  for (std::size_t i = 0; i + 2 < light.triangles.size(); i += 3)
    triangles.push_back({light.triangles[i], light.triangles[i + 1], light.triangles[i + 2]});
  return triangles;
}

}  // namespace

LightIrradiance::LightIrradiance(const LightSetup& lights) : lights_(lights) {
  find_flat_lights();
  if (!flat_.empty()) images_ = lights.paths().mirrors().images_of_point();
}

// The sources of a set-up are the problem's lights, then media, then walls.
void LightIrradiance::find_flat_lights() {
  const Problem& problem = lights_.problem();
  auto source = lights_.sources().begin();
  const auto next = [&] {
    if (source == lights_.sources().end()) throw std::logic_error("a light has no source");
    return (source++)->get();
  };
  for (std::size_t i = 0; i < problem.lights().size(); ++i) {
    const Light& light = problem.lights()[i];
    if (continues_sky(problem.lights(), i) || light.uncollided == Uncollided::no) continue;
    const LightSource* shining = next();
    if (const auto* surface = std::get_if<SurfaceLight>(&light.kind))
      flat_.push_back({shining, surface->radiance, triangles_of(*surface)});
    else
      others_.push_back(shining);
  }
  for (int region = 0; region < static_cast<int>(problem.media().size()); ++region)
    if (lights_.has_region(region)) others_.push_back(next());
  for (int wall = 0; wall < static_cast<int>(problem.walls().size()); ++wall)
    if (lights_.has_wall(wall))
      flat_.push_back({next(), problem.wall(wall).radiance, triangles_of_wall(problem.mesh(), wall)});
}

UncollidedAtPoint LightIrradiance::at(const PointInCell& point, const Vec3& normal) const {
  const std::size_t bands = lights_.paths().bands();
  UncollidedAtPoint light{std::vector<double>(bands, 0), std::vector<double>(bands, 0)};
  LightBeams beams(bands);
  const auto add = [&](const LightSource& source, Sight sight, LightDetail detail, double factor) {
    beams.clear();
    source.add_beams(point, sight, detail, beams);
    add_beams(beams, normal, factor, light);
    return beams.size();
  };
  for (const LightSource* source : others_) add(*source, Sight::attenuated, fine_light, 1);
  LightDetail each = each_triangle;
  each.creases = &lights_.creases();
  for (const FlatLight& flat : flat_) {
    // Nothing of it is seen: no rounding is to be left of (1).
    if (add(*flat.source, Sight::attenuated, each, 1) == 0) continue;
    add(*flat.source, Sight::clear, each, -1);
    for (const MirrorSet mirrors : images_) add_clear(flat, mirrors, point.position, normal, light);
  }
  return light;
}

// Through mirrors the meter is moved behind them instead of the light.
void LightIrradiance::add_clear(const FlatLight& flat, MirrorSet mirrors, const Vec3& position,
                                const Vec3& normal, UncollidedAtPoint& light) const {
  const MirrorPlanes& planes = lights_.paths().mirrors();
  const Vec3 eye = planes.image(mirrors, position), up = planes.image_direction(mirrors, normal);
  for (const std::array<Vec3, 3>& triangle : flat.triangles) {
    const std::array<Vec3, 3> seen = {triangle[0] - eye, triangle[1] - eye, triangle[2] - eye};
    const Vec3 front = (seen[1] - seen[0]).cross(seen[2] - seen[0]);
    if (front.dot(seen[0]) >= 0) continue;  // it shines the other way
    const double across = polygon_irradiance(seen, up), all = triangle_solid_angle(seen);
    for (std::size_t b = 0; b < flat.radiance.size(); ++b) {
      const double arrives = flat.radiance[b] * planes.reflectance(mirrors, b);
      light.irradiance[b] += arrives * across;
      light.fluence[b] += arrives * all;
    }
  }
}

}  // namespace etendue
