// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/tetrahedra/connectivity.h"
#include "mesh/tetrahedra/raw_mesh.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// +1 where the order of three vertices is an even permutation of the rising one, else -1.
int turn_of(const std::array<std::int32_t, 3>& vertices);

/// [raw point] vertex, or -1 where no cell uses the point.
std::vector<std::int32_t> vertex_of_point(const MeshNumbering& numbering, const RawMesh& raw);

/// The faces, by their rising vertices and sorted, that named triangles stand for from both sides: where
/// cells lie on both, what parts them is a sheet.
std::vector<std::array<std::int32_t, 3>> sheet_faces(const MeshNumbering& numbering, const RawMesh& raw);

/// The vertices of the faces that lie on the boundary twice, once from each side: of sheets, rims included.
/// Rising.
std::vector<std::int32_t> vertices_of_sheets(const TetrahedralMesh& mesh);

/// [boundary face] the face on the other side of a sheet, with the same vertices in the same order; -1 where
/// there is none.
std::vector<std::int32_t> faces_behind(const TetrahedralMesh& mesh);

}  // namespace etendue
