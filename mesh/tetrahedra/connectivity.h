// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tetrahedra/raw_mesh.h"

namespace etendue {

/// From the numbers of a mesh back to those of the raw mesh it is made of.
struct MeshNumbering {
  std::vector<std::int32_t> cells;     ///< [cell] raw cell
  std::vector<std::int32_t> vertices;  ///< [vertex] raw point
};

/// Cells whose vertices rise, and whether that order is positively oriented (+1) or not (-1).
struct SortedCells {
  std::vector<std::array<std::int32_t, 4>> vertices;  ///< [cell]
  std::vector<std::int8_t> orientation;               ///< [cell]
};

/// Sorts the vertices of positively oriented cells.
SortedCells sort_vertices(std::span<const std::array<std::int32_t, 4>> oriented_cells);

/// The faces between cells. Boundary faces come first; both kinds are numbered by the cell that meets them
/// first, and that cell is the owner.
struct MeshFaces {
  std::vector<std::array<std::int32_t, 3>> vertices;  ///< [face] rising
  std::vector<std::array<std::int32_t, 2>> cells;     ///< [face] {owner, neighbour}, -1 on the boundary
  std::vector<std::int8_t> orientation;               ///< [face] +1: (b-a) x (c-a) points out of the owner
  std::vector<std::array<std::int32_t, 4>> of_cell;   ///< [cell] face f lies opposite vertex f
  std::int32_t boundary_count = 0;
};

/// Matches the faces of cells. Throws InputError, in the numbers of the raw mesh, where more than two cells
/// share a face or two lie on the same side of it, that is overlap.
MeshFaces connect_faces(const SortedCells& cells, const MeshNumbering& numbering, const RawMesh& raw);

}  // namespace etendue
