// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdlib>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue::test {

inline bool is_index(int index, std::size_t count) {
  return index >= 0 && static_cast<std::size_t>(index) < count;
}

/// Ends the program where the arrays of a mesh do not fit together. Throws InputError where it is no valid
/// mesh.
inline void check(const RawMesh& mesh) {
  if (mesh.cell_regions.size() != mesh.cells.size() || mesh.triangle_walls.size() != mesh.triangles.size())
    std::abort();
  for (const Vec3& point : mesh.points)
    if (!point.allFinite()) std::abort();
  for (const auto& cell : mesh.cells)
    for (const int point : cell)
      if (!is_index(point, mesh.points.size())) std::abort();
  for (const auto& triangle : mesh.triangles)
    for (const int point : triangle)
      if (!is_index(point, mesh.points.size())) std::abort();
  for (const int region : mesh.cell_regions)
    if (!is_index(region, mesh.region_names.size())) std::abort();
  for (const int wall : mesh.triangle_walls)
    if (!is_index(wall, mesh.wall_names.size())) std::abort();
  const TetrahedralMesh checked(mesh);
}

}  // namespace etendue::test
