// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "mesh/tetrahedra/raw_mesh.h"

namespace etendue {

/// Reads the mesh whose .node, .ele and, where it exists, .face file stand beside each other; `path` is any
/// of them. Regions are named by the first attribute of the cells, walls by the markers of the faces.
RawMesh read_tetgen_files(const std::filesystem::path& path);

}  // namespace etendue
