// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/problem/problem.h"
#include "solver/radiosity/solve/solve_radiosity.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue {

/// A mesh with a non-participating medium in which every wall reflects the same, and the wall of this name
/// has exitance 1.
Problem empty_room(const TetrahedralMesh& mesh, double reflectance, const std::string& bright);

/// A cube of side 1 with a box in it that is no part of the domain: walls zmin and so on, and crate.zmin …
TetrahedralMesh room_with_crate(double max_volume);

/// Mean of [boundary face][3] over a wall.
double mean_on(const TetrahedralMesh& mesh, const std::vector<double>& values, const std::string& wall);

}  // namespace etendue
