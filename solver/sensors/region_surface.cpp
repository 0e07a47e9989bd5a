// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/sensors/region_surface.h"

namespace etendue {

std::vector<SurfaceFace> surface_of(const TetrahedralMesh& mesh, int region) {
  std::vector<SurfaceFace> surface;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const FaceIndex face(f);
    const bool wall = f < mesh.boundary_face_count();
    const bool owned = mesh.region(mesh.owner(face)) == region;
    const bool beyond = !wall && mesh.region(mesh.neighbour(face)) == region;
    if (owned == beyond) continue;
    if (owned)
      surface.push_back({face, mesh.owner(face), wall ? std::nullopt : std::optional(mesh.neighbour(face)),
                         mesh.area_normal(face)});
    else
      surface.push_back({face, mesh.neighbour(face), mesh.owner(face), -mesh.area_normal(face)});
  }
  return surface;
}

}  // namespace etendue
