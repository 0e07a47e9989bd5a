// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

inline std::map<std::string, double> region_volumes(const TetrahedralMesh& mesh) {
  std::map<std::string, double> volumes;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    volumes[mesh.region_names()[static_cast<std::size_t>(mesh.region(CellIndex(c)))]] +=
        mesh.volume(CellIndex(c));
  return volumes;
}

/// Vector areas that point out of the domain, by wall.
inline std::map<std::string, Vec3> wall_area_normals(const TetrahedralMesh& mesh) {
  std::map<std::string, Vec3> areas;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    areas.try_emplace(mesh.wall_names()[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))], Vec3::Zero())
        .first->second += mesh.area_normal(FaceIndex(f));
  return areas;
}

}  // namespace etendue
