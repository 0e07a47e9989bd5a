// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/errors.h"
#include "base/up_axis.h"
#include "mesh/files/vtk/mesh_file_options.h"
#include "mesh/tetrahedra/raw_mesh.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// A mesh by the ending of its name: Gmsh .msh (2.2 and 4.1 ASCII, physical names kept), VTK .vtu (cell array
/// `region` on cells, `wall` on triangles and polygons, names in the field data), TetGen .node, .ele or .face
/// (any of them; siblings are found), or the folder of an OpenFOAM case. Cells that are not tetrahedra are
/// cut into tetrahedra, which know their parents. Coordinates are multiplied by `scale`, and turned so that
/// z is up. Throws FileError where it cannot be opened, InputError with file and line where its content is
/// wrong. `origin` is that of the key that names the file.
RawMesh read_mesh(const std::filesystem::path& path, double scale = 1, const Origin& origin = {},
                  UpAxis up = UpAxis::z);

/// Writes a mesh as .vtu, read back identically by read_mesh. Written to a temporary name and renamed.
void write_mesh(const std::filesystem::path& path, const TetrahedralMesh& mesh,
                const MeshFileOptions& options = {});

}  // namespace etendue
