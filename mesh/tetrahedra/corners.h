// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// Corner `i` of a cell or face, of those in mesh.vertices().
template <class Tag>
const Vec3& corner_of(const TetrahedralMesh& mesh, Index<Tag> item, std::size_t i) {
  return mesh.point(VertexIndex(mesh.vertices(item)[i]));
}

/// Corners of a cell, in the order of mesh.vertices().
inline std::array<Vec3, 4> corners_of(const TetrahedralMesh& mesh, CellIndex cell) {
  const auto& v = mesh.vertices(cell);
  return {mesh.point(VertexIndex(v[0])), mesh.point(VertexIndex(v[1])), mesh.point(VertexIndex(v[2])),
          mesh.point(VertexIndex(v[3]))};
}

/// Corners of a face, in the order of mesh.vertices().
inline std::array<Vec3, 3> corners_of(const TetrahedralMesh& mesh, FaceIndex face) {
  const auto& v = mesh.vertices(face);
  return {mesh.point(VertexIndex(v[0])), mesh.point(VertexIndex(v[1])), mesh.point(VertexIndex(v[2]))};
}

}  // namespace etendue
