// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/case/case.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// A line for each field from a file: where it is used, and its range and mean there.
std::vector<std::string> field_texts(const Case& input, const TetrahedralMesh& mesh);

}  // namespace etendue
