// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <variant>

#include "mesh/files/vtk/mesh_file_options.h"
#include "mesh/polyhedra/polyhedral_mesh.h"
#include "mesh/tetrahedra/raw_mesh.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// Reads tetrahedra and named triangles from a VTK unstructured grid: cell array `region` on tetrahedra and
/// `wall` on triangles (-1: none), numbers into the string arrays `region_names` and `wall_names` of the
/// field data, or names themselves where there are no such arrays. Polyhedra, and polygons of walls too,
/// where a cell with a volume is not a tetrahedron.
std::variant<RawMesh, PolyhedralMesh> read_vtu_file(const std::filesystem::path& path);

/// Writes what read_vtu_file reads: the tetrahedra, then the boundary triangles, seen from outside. The cell
/// arrays `region_name` and `wall_name` repeat the names for viewers; the reader needs them not.
void write_vtu_file(const std::filesystem::path& path, const TetrahedralMesh& mesh,
                    const MeshFileOptions& options);

}  // namespace etendue
