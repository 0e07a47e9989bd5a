// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/camera/gather.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/field_view.h"
#include "base/parallel/parallel_for.h"
#include "mesh/tetrahedra/corners.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Directions about z of equal parts of the integral of cos over the half range: by Nusselt's
/// analogy equal parts of a disc, rings times azimuths.
std::vector<Vec3> half_range_rays(int rays) {
  const int side = static_cast<int>(std::lround(std::sqrt(rays)));
  const int rings = (side + 1) / 2, azimuths = rays / rings;
  std::vector<Vec3> directions;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < azimuths; ++j) {
      const double radius = std::sqrt((i + 0.5) / rings), angle = 2 * pi * (j + 0.5 * (i % 2)) / azimuths;
      directions.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                              std::sqrt(1 - radius * radius));
    }
  return directions;
}

/// [band] at a corner of a boundary face.
std::vector<double> irradiance_at(const RayRadiance& scene, const WallCorner& corner,
                                  const std::vector<Vec3>& rays, int shadow_rays,
                                  RayRadiance::Workspace& work) {
  const TetrahedralMesh& mesh = scene.problem().mesh();
  const Vec3 vertex = corner_of(mesh, corner.face, corner.node);
  const PointInCell start{mesh.owner(corner.face),
                          vertex + off_the_vertex * (mesh.centroid(corner.face) - vertex)};
  const Vec3 inwards = -mesh.area_normal(corner.face).normalized();
  const Vec3 u = inwards.unitOrthogonal(), v = inwards.cross(u);
  const RayView view{.glossy = 0, .lights_shown = false, .shadow_rays = shadow_rays};
  std::vector<double> sum(scene.bands(), 0), radiance(scene.bands());
  for (const Vec3& ray : rays) {
    scene.along(start, ray.x() * u + ray.y() * v + ray.z() * inwards, view, work, radiance);
    for (std::size_t b = 0; b < sum.size(); ++b) sum[b] += radiance[b];
  }
  for (double& value : sum) value *= pi / static_cast<double>(rays.size());
  return sum;
}

bool uses_irradiance(const Wall& wall) {
  return wall.transmits() || std::ranges::any_of(wall.diffuse, [](double value) { return value > 0; });
}

}  // namespace

WallIrradiance gather(const RayRadiance& scene, int rays, int shadow_rays, int threads,
                      const StageObserver& observer) {
  if (rays == 0) return {};
  const TetrahedralMesh& mesh = scene.problem().mesh();
  const auto faces = static_cast<std::size_t>(mesh.boundary_face_count());
  WallIrradiance result{std::vector<double>(faces * 3 * scene.bands(), 0), std::vector<double>(faces, pi)};
  const std::vector<std::vector<WallCorner>> planes = corners_by_plane(mesh);
  const std::vector<Vec3> directions = half_range_rays(rays);
  StageCounter counter(planes.size(), observer);
  const auto bring = [&](std::size_t p, RayRadiance::Workspace& work) {
    bool seen = false;
    for (const WallCorner& corner : planes[p])
      seen = seen || uses_irradiance(scene.problem().wall(mesh.wall(corner.face)));
    if (!seen) return counter.add();
    const std::vector<double> irradiance =
        irradiance_at(scene, planes[p].front(), directions, shadow_rays, work);
    const FaceField values(result.values, scene.bands());
    for (const WallCorner& corner : planes[p])
      for (std::size_t b = 0; b < scene.bands(); ++b) values(corner.face, corner.node, b) = irradiance[b];
    return counter.add();
  };
  const bool whole = parallel_for(
      planes.size(), threads, 1, [&] { return RayRadiance::Workspace(scene); }, bring);
  if (!whole) return {};
  return result;
}

}  // namespace etendue
