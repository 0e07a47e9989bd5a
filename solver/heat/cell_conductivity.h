// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/heat/heat_problem.h"

namespace etendue {

/// Mean conductivity of a cell with these temperatures at its vertices [W/(m K)]. Throws InputError where it
/// is negative or not finite.
double cell_conductivity(const HeatMedium& medium, const TetrahedralMesh& mesh, CellIndex cell,
                         const std::array<double, 4>& kelvin);

}  // namespace etendue
