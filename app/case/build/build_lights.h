// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "app/case/case.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/problem/problem.h"

namespace etendue {

/// The lights of a case. Those that are walls become the walls' radiance.
std::vector<Light> build_lights(const Case& input, const TetrahedralMesh& mesh, std::vector<Wall>& walls);

}  // namespace etendue
