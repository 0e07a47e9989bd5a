// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "app/case/case.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/heat/heat_problem.h"

namespace etendue {

/// The heat of the case's media on this mesh. The iteration starts from the mean emissive power of what has a
/// temperature.
std::optional<HeatProblem> build_heat(const Case& input, const TetrahedralMesh& mesh);

}  // namespace etendue
