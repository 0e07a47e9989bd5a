// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/refraction/smooth_planes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "solver/problem/mirror.h"

namespace etendue {

std::vector<SmoothPlane> smooth_planes(const TetrahedralMesh& mesh, std::span<const Wall> walls) {
  constexpr double parallel = 1e-10;  // normals of one flat wall differ by rounding only
  std::vector<SmoothPlane> planes;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const Wall& wall = walls[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))];
    if (!is_mirror(wall)) continue;
    const Vec3 normal = mesh.area_normal(FaceIndex(f)).normalized();
    const bool known = std::ranges::any_of(planes, [&](const SmoothPlane& plane) {
      return plane.refractive_index == wall.refractive_index && normal.cross(plane.normal).norm() < parallel;
    });
    if (!known) planes.push_back({normal, wall.refractive_index});
  }
  return planes;
}

}  // namespace etendue
