// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/tetrahedra/connectivity.h"
#include "mesh/tetrahedra/raw_mesh.h"

namespace etendue {

/// Names and, for each thing that has one, the index of its name.
struct NamedParts {
  std::vector<std::int32_t> parts;
  std::vector<std::string> names;
};

/// Keeps the names that are used, in their order, each once.
NamedParts used_names(std::vector<std::int32_t> parts, const std::vector<std::string>& names);

/// [boundary face] the named triangle of the raw mesh that it is, or -1. Triangles between two cells are
/// interfaces and count for nothing, those of sheets name their own side. Throws InputError where a triangle
/// is no face of the mesh, or where a face has two names.
std::vector<std::int32_t> boundary_triangles(const MeshFaces& faces, const MeshNumbering& numbering,
                                             const RawMesh& raw);

/// The wall of each boundary face from its triangle. Throws InputError where some boundary faces have a name
/// and others none. Where none has, all are "boundary".
NamedParts name_walls(const std::vector<std::int32_t>& triangles, const MeshFaces& faces,
                      const MeshNumbering& numbering, const RawMesh& raw);

}  // namespace etendue
