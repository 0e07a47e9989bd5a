// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// [boundary face][i] The boundary face beyond the edge opposite vertex i where both lie in one plane, look
/// to the same side and nothing stands on the edge between them; else -1. What falls on a wall changes
/// continuously across such edges, and jumps where a sheet has its foot.
std::vector<std::array<std::int32_t, 3>> flat_neighbours(const TetrahedralMesh& mesh);

}  // namespace etendue
