// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/problem/problem.h"

namespace etendue {

/// The numbers of the walls by which the sky comes in where nobody names them: outer ones that neither shine
/// nor reflect nor let light through. `walls` are those of the mesh, in its order.
std::vector<int> open_walls(const TetrahedralMesh& mesh, std::span<const Wall> walls);

}  // namespace etendue
