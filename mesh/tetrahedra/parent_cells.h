// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "mesh/polyhedra/polyhedral_mesh.h"

namespace etendue {

/// The mesh that tetrahedra were cut from, and which of its cells and faces each lies in.
struct ParentCells {
  std::shared_ptr<const PolyhedralMesh> mesh;  ///< null: the tetrahedra were not cut from others' cells
  std::vector<std::int32_t> cells;             ///< [cell] the cell that it is a part of
  std::vector<std::int32_t> faces;  ///< [triangle] the face that it is a part of; -1: of no named one
};

}  // namespace etendue
