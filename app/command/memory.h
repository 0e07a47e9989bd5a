// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// Throws InputError with the figures where the fields of a solution alone are larger than the memory of this
/// machine. Without this the system would kill the program hours later, or others.
void check_memory(const TetrahedralMesh& mesh, int bands);

/// What to say after std::bad_alloc.
std::string out_of_memory_message();

}  // namespace etendue
