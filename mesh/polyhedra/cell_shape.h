// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/polyhedra/faces_of_cells.h"

namespace etendue {

enum class CellKind { pyramid, prism, polyhedron };

/// A cell by its points, where its kind tells the faces: a pyramid (also a tetrahedron) has a base and a
/// point above it, a prism (also a hexahedron) a base and the same above it.
struct CellShape {
  CellKind kind = CellKind::polyhedron;
  std::vector<int> points;  ///< those of the base, counterclockwise as seen from above, then those above it
};

CellShape shape_of_cell(const PolyhedralMesh& mesh, std::span<const FaceOfCell> faces);

}  // namespace etendue
