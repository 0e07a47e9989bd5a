// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <variant>

#include "mesh/polyhedra/polyhedral_mesh.h"
#include "mesh/tetrahedra/raw_mesh.h"

namespace etendue {

/// Reads a VTK unstructured grid by VTK's own reader, which trusts the file: a corrupt one can take the
/// process along. Polyhedra where a cell with a volume is not a tetrahedron. Throws InputError where it, or
/// what is read, is wrong.
std::variant<RawMesh, PolyhedralMesh> read_vtu_grid(const std::filesystem::path& path);

}  // namespace etendue
