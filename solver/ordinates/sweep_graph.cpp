// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/ordinates/sweep_graph.h"

#include <fmt/format.h>

#include "mesh/base/errors.h"

namespace etendue {

SweepGraph::SweepGraph(const TetrahedralMesh& mesh)
    : mesh_(mesh), walls_(mesh), cells_(static_cast<std::size_t>(mesh.cell_count())) {
  if (mesh.cell_count() >= most_cells)
    throw InputError(
        fmt::format("the mesh has {} cells; a sweep can order {}", mesh.cell_count(), most_cells - 1));
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    Cell& cell = cells_[static_cast<std::size_t>(c)];
    cell.faces = mesh.faces(CellIndex(c));
    for (unsigned k = 0; k < 4; ++k) {
      const FaceIndex face(cell.faces[k]);
      const bool owner = mesh.owner(face) == CellIndex(c);
      if (owner) cell.owned |= 1U << k;
      if (face.value() < mesh.boundary_face_count()) {
        cell.boundary |= 1U << k;
        cell.behind[k] = packed({walls_.inflow(face.value()), 3});
      } else {
        const CellIndex other = owner ? mesh.neighbour(face) : mesh.owner(face);
        cell.behind[k] =
            packed({static_cast<std::uint32_t>(other.value()), opposite_node(mesh, other, face)});
      }
    }
  }
}

}  // namespace etendue
