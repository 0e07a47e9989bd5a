// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "base/log.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"

namespace etendue {

/// The case's geometry or file as a checked mesh. Names in the case that no cell or facet carries, and
/// regions or walls of the mesh without an entry, are faults that list the names there are.
TetrahedralMesh build_mesh(const Case& input, const Log& log = {});

/// The case's media and walls on this mesh.
Problem build_problem(const Case& input, const TetrahedralMesh& mesh);

/// Throws InputError where a kernel that is the same everywhere is negative, makes light, is not reciprocal
/// though that is claimed, or is for another direction set. One that depends on the place asks for the mesh.
void check_kernels(const Case& input);

/// The case's directions, rotated where it asks for that. Their weights do not know the case's walls.
DirectionSet build_directions(const Case& input);
/// These, with weights for the walls that refract.
DirectionSet build_directions(const Case& input, const Problem& problem);
/// These and, where the case asks for more rotations, copies that are turned at random.
std::vector<DirectionSet> build_rotated_directions(const Case& input, const Problem& problem);
/// Those of light that has collided once, rotated and copied in the same way; empty where the case has none.
std::vector<DirectionSet> build_first_collided_directions(const Case& input, const Problem& problem);

}  // namespace etendue
