// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/lights/sky_irradiance.h"

#include <algorithm>
#include <array>

#include "mesh/tetrahedra/corners.h"
#include "solver/uncollided/closed_form/polygon_irradiance.h"
#include "solver/uncollided/closed_form/triangle.h"

namespace etendue {
namespace {

/// Triangles are cut until they are seen within such a solid angle [sr], as one with sides of three degrees,
/// and their sides are shorter than this part of their distance.
constexpr double small_solid_angle = 1.2e-3, small_side = 0.15;
/// Halvings of a face at most, for points that lie nearly on it.
constexpr int most_face_halvings = 60;

/// Halves a triangle, of corners relative to the point, along its longest side until it is small, and calls
/// found(triangle).
template <class Found>
void for_small_parts(const Triangle& triangle, int halvings, const Found& found) {
  std::size_t longest = 0;
  double least = triangle[0].norm();
  const auto side = [&](std::size_t i) { return (triangle[(i + 1) % 3] - triangle[i]).norm(); };
  for (std::size_t i = 1; i < 3; ++i) {
    if (side(i) > side(longest)) longest = i;
    least = std::min(least, triangle[i].norm());
  }
  if (halvings == 0 ||
      (side(longest) < small_side * least && triangle_solid_angle(triangle) < small_solid_angle))
    return found(triangle);
  const Vec3 &a = triangle[longest], &b = triangle[(longest + 1) % 3], &c = triangle[(longest + 2) % 3];
  const Vec3 middle = (a + b) / 2;
  for_small_parts({a, middle, c}, halvings - 1, found);
  for_small_parts({middle, b, c}, halvings - 1, found);
}

}  // namespace

SkyIrradiance::SkyIrradiance(const SkySource& sky, const LightPaths& paths) : sky_(sky), paths_(paths) {
  const TetrahedralMesh& mesh = paths.problem().mesh();
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    if (sky.comes_in_by(mesh.wall(FaceIndex(f)))) faces_.push_back(FaceIndex(f));
}

void SkyIrradiance::add(const PointInCell& at, const Vec3& normal, std::span<double> irradiance,
                        std::span<double> fluence) const {
  const TetrahedralMesh& mesh = paths_.problem().mesh();
  std::vector<double> transmittance(paths_.bands());
  for (const FaceIndex face : faces_) {
    Triangle corners = corners_of(mesh, face);
    for (Vec3& corner : corners) corner -= at.position;
    // Seen from behind or in its own plane it brings nothing.
    if (corners[0].dot(mesh.area_normal(face)) <= 0) continue;
    for_small_parts(corners, most_face_halvings, [&](const Triangle& part) {
      const double across = polygon_irradiance(part, normal);
      const Vec3 towards = (part[0] + part[1] + part[2]).normalized();
      const auto out = paths_.leave(at, towards, transmittance);
      if (!out || out->face != face) return;
      const std::span<const double> radiance = sky_.radiance(towards);
      const double all = triangle_solid_angle(part);
      for (std::size_t b = 0; b < irradiance.size(); ++b) {
        irradiance[b] += radiance[b] * transmittance[b] * across;
        fluence[b] += radiance[b] * transmittance[b] * all;
      }
    });
  }
}

}  // namespace etendue
