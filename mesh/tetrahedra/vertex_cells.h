// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// [vertex] The first of the cells around it.
std::vector<CellIndex> cells_of_vertices(const TetrahedralMesh& mesh);

/// [vertex] The number of the last cell around it that is wanted, `wanted(CellIndex)`; -1 without.
template <class Wanted>
std::vector<std::int32_t> wanted_cells_of_vertices(const TetrahedralMesh& mesh, const Wanted& wanted) {
  std::vector<std::int32_t> cells(static_cast<std::size_t>(mesh.vertex_count()), -1);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    if (wanted(CellIndex(c)))
      for (const std::int32_t v : mesh.vertices(CellIndex(c))) cells[static_cast<std::size_t>(v)] = c;
  return cells;
}

}  // namespace etendue
