// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdio>
#include <string_view>

#include "mesh/polyhedra/polyhedral_mesh.h"
#include "mesh/tetrahedra/raw_mesh.h"

namespace etendue {

// A raw mesh on its way from a child process to this one; without the file's name and lines.
void write_raw_mesh(std::FILE* file, const RawMesh& mesh);
RawMesh take_raw_mesh(std::string_view bytes);

// The same of a polyhedral mesh, without the file's name and patches.
void write_polyhedral_mesh(std::FILE* file, const PolyhedralMesh& mesh);
PolyhedralMesh take_polyhedral_mesh(std::string_view bytes);

}  // namespace etendue
