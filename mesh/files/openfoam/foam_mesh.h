// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "mesh/polyhedra/polyhedral_mesh.h"

namespace etendue {

/// Reads the mesh of an OpenFOAM case, constant/polyMesh in its folder, or polyMesh in the folder of one
/// region: ascii or binary. Patches are walls, cell zones are regions; a cell without zone is of the region
/// "domain". Throws FileError where a file cannot be opened, InputError with file and line where its content
/// is wrong or a patch couples to another (cyclic, processor) or leaves out a dimension (empty, wedge).
PolyhedralMesh read_foam_mesh(const std::filesystem::path& folder);

}  // namespace etendue
