// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/adjacency/vertex_cells.h"

namespace etendue {

std::vector<CellIndex> cells_of_vertices(const TetrahedralMesh& mesh) {
  std::vector<CellIndex> cells(static_cast<std::size_t>(mesh.vertex_count()), CellIndex(0));
  for (std::int32_t c = mesh.cell_count() - 1; c >= 0; --c)
    for (const std::int32_t v : mesh.vertices(CellIndex(c)))
      cells[static_cast<std::size_t>(v)] = CellIndex(c);
  return cells;
}

}  // namespace etendue
