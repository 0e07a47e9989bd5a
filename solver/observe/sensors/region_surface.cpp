// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/sensors/region_surface.h"

namespace etendue {
namespace {

bool lies_beyond(const TetrahedralMesh& mesh, const SurfaceFace& part, const Beyond& beyond) {
  if (beyond.region >= 0) return part.outside && mesh.region(*part.outside) == beyond.region;
  if (beyond.wall >= 0) return !part.outside && mesh.wall(part.face) == beyond.wall;
  return true;
}

}  // namespace

std::vector<SurfaceFace> surface_of(const TetrahedralMesh& mesh, int region, const Beyond& beyond) {
  std::vector<SurfaceFace> surface;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const FaceIndex face(f);
    const bool wall = f < mesh.boundary_face_count();
    const bool owned = mesh.region(mesh.owner(face)) == region;
    const bool across = !wall && mesh.region(mesh.neighbour(face)) == region;
    if (owned == across) continue;
    const SurfaceFace part =
        owned ? SurfaceFace{face, mesh.owner(face), wall ? std::nullopt : std::optional(mesh.neighbour(face)),
                            mesh.area_normal(face)}
              : SurfaceFace{face, mesh.neighbour(face), mesh.owner(face), -mesh.area_normal(face)};
    if (lies_beyond(mesh, part, beyond)) surface.push_back(part);
  }
  return surface;
}

std::vector<SurfaceFace> surface_of_wall(const TetrahedralMesh& mesh, int wall) {
  std::vector<SurfaceFace> surface;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    if (mesh.wall(FaceIndex(f)) == wall)
      surface.push_back(
          {FaceIndex(f), mesh.owner(FaceIndex(f)), std::nullopt, mesh.area_normal(FaceIndex(f))});
  return surface;
}

}  // namespace etendue
