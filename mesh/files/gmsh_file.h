// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "mesh/tetrahedra/raw_mesh.h"

namespace etendue {

/// Reads a Gmsh mesh of version 2.2 or 4.1 in ASCII (Geuzaine and Remacle 2009; Gmsh 4.11 reference manual,
/// sections 10.1 and 10.4). Regions and walls are the physical groups: by name, else by number.
RawMesh read_gmsh_file(const std::filesystem::path& path);

}  // namespace etendue
