// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/order/sweep_slots.h"

#include <algorithm>

namespace etendue {

WallSlots::WallSlots(const TetrahedralMesh& mesh)
    : of_cell_(static_cast<std::size_t>(mesh.cell_count()), 0),
      count_(1 + static_cast<std::uint32_t>(mesh.boundary_face_count())) {
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const CellIndex cell = mesh.owner(FaceIndex(f));
    std::uint32_t& slot = of_cell_[cell.at()];
    if (slot == 0) slot = count_++;
    inside_.push_back({slot, opposite_node(mesh, cell, FaceIndex(f))});
  }
}

std::uint32_t opposite_node(const TetrahedralMesh& mesh, CellIndex cell, FaceIndex face) {
  const auto& faces = mesh.faces(cell);
  return static_cast<std::uint32_t>(std::find(faces.begin(), faces.end(), face.value()) - faces.begin());
}

}  // namespace etendue
