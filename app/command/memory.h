// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// Throws InputError with the figures where solving and writing may take more than the memory of this
/// machine. Without this the system would kill the program hours later, or others. `solving` is
/// estimate_memory's answer [bytes].
void check_memory(std::size_t solving, const TetrahedralMesh& mesh, int bands);

/// What to say after std::bad_alloc.
std::string out_of_memory_message();

}  // namespace etendue
