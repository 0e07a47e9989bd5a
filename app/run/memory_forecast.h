// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "app/case/case.h"
#include "app/run/ordinates_setup.h"
#include "app/setup/run_options.h"
#include "base/log.h"
#include "solver/problem/problem.h"

namespace etendue {

/// Of a run by discrete ordinates, with light in time.
RunMemory directions_run_memory(const Case& input, const Problem& problem, const OrdinatesSetup& setup);

/// memory_text() for the cells that the case asks for, from what a run by ordinates or photons needs on the
/// coarsest cells.
std::string expected_memory_text(const RunMemory& memory, const Case& input, const Problem& coarse,
                                 const Log& log);

/// Cells of the mesh that a case asks for, about, from one with the coarsest cells.
double expected_cells(const MeshCase& wanted, const TetrahedralMesh& coarse);

}  // namespace etendue
