// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"

namespace etendue {

/// Of this machine [bytes].
double installed_memory();

/// Which regions scatter by a matrix, and what keeping their angular solution once takes; empty where none
/// does.
std::string matrix_memory_text(const Problem& problem, const DirectionSet& directions);

/// What solving and writing will take, as a line. Throws InputError with the figures where that may be more
/// than the memory of this machine: without this the system would kill the program hours later, or others.
/// `solving` is an upper estimate and `expected` the likely peak [bytes], where it is another; `matrices` is
/// matrix_memory_text's answer.
std::string check_memory(std::size_t solving, const TetrahedralMesh& mesh, int bands,
                         const std::string& matrices = "", std::size_t expected = 0);

/// The same of a mesh that is not made yet: `solving` [bytes] and `cells` are expected.
std::string check_expected_memory(double solving, double cells, int bands, const std::string& matrices = "");

/// What to say after std::bad_alloc.
std::string out_of_memory_message();

}  // namespace etendue
