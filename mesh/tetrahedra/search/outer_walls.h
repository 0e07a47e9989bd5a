// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// [wall] Whether it looks out of the mesh: straight out from one of its faces at least nothing of the mesh
/// stands. Walls of holes and of sheets do not.
std::vector<bool> outer_walls(const TetrahedralMesh& mesh);

}  // namespace etendue
