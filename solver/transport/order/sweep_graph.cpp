// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/order/sweep_graph.h"

#include <fmt/format.h>

#include "base/errors.h"

namespace etendue {

SweepGraph::SweepGraph(const TetrahedralMesh& mesh)
    : mesh_(mesh),
      walls_(mesh),
      behind_(static_cast<std::size_t>(mesh.cell_count())),
      faces_(behind_.size()) {
  if (mesh.cell_count() >= most_cells)
    throw InputError(
        fmt::format("the mesh has {} cells; a sweep can order {}", mesh.cell_count(), most_cells - 1));
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    std::array<std::uint32_t, 4>& behind = behind_[static_cast<std::size_t>(c)].faces;
    Faces& faces = faces_[static_cast<std::size_t>(c)];
    faces.numbers = mesh.faces(CellIndex(c));
    for (unsigned k = 0; k < 4; ++k) {
      const FaceIndex face(faces.numbers[k]);
      const bool owner = mesh.owner(face) == CellIndex(c);
      if (owner) faces.owned |= 1U << k;
      if (face.value() < mesh.boundary_face_count()) {
        faces.boundary |= 1U << k;
        behind[k] = packed({walls_.inflow(face.value()), 3});
      } else {
        const CellIndex other = owner ? mesh.neighbour(face) : mesh.owner(face);
        behind[k] = packed({static_cast<std::uint32_t>(other.value()), opposite_node(mesh, other, face)});
      }
    }
  }
}

}  // namespace etendue
