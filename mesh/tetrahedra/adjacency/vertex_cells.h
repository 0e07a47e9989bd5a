// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// [vertex] The first of the cells around it.
std::vector<CellIndex> cells_of_vertices(const TetrahedralMesh& mesh);

}  // namespace etendue
