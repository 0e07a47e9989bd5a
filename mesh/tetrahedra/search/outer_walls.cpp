// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/search/outer_walls.h"

#include <cmath>

#include "mesh/tetrahedra/search/boundary_tree.h"

namespace etendue {

std::vector<bool> outer_walls(const TetrahedralMesh& mesh) {
  // Before the face, so that the other side of a sheet stands behind it.
  constexpr double before = 1e-9;
  const BoundaryTree tree(mesh);
  std::vector<bool> outer(mesh.wall_names().size(), false);
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    const auto wall = static_cast<std::size_t>(mesh.wall(face));
    if (outer[wall]) continue;
    const Vec3 normal = mesh.area_normal(face).normalized();
    const Vec3 from = mesh.centroid(face) - before * std::sqrt(mesh.area(face)) * normal;
    outer[wall] = !tree.first_entry(from, normal);
  }
  return outer;
}

}  // namespace etendue
