// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/case/case.h"
#include "mesh/base/log.h"
#include "solver/problem/problem.h"

namespace etendue {

/// Memory of a run on this very mesh as a line; empty by radiosity, which takes its memory for patches that
/// it cuts as it goes. Throws InputError as the run does where this machine has not so much.
std::string memory_text(const Case& input, const Problem& problem);

/// The same for the cells that the case asks for, from a problem on the coarsest cells.
std::string expected_memory_text(const Case& input, const Problem& coarse, const Log& log);

/// Cells of the mesh that a case asks for, about, from one with the coarsest cells.
double expected_cells(const MeshCase& wanted, const TetrahedralMesh& coarse);

}  // namespace etendue
