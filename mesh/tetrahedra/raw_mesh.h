// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/vec3.h"
#include "mesh/tetrahedra/parent_cells.h"

namespace etendue {

/// Tetrahedra as a file or a mesher gives them: not yet checked, in any order.
struct RawMesh {
  std::vector<Vec3> points;
  std::vector<std::array<int, 4>> cells;      ///< indices of points
  std::vector<int> cell_regions;              ///< [cell] index into region_names
  std::vector<std::array<int, 3>> triangles;  ///< boundary triangles that have a name, and sheet_faces.h's
  std::vector<int> triangle_walls;            ///< [triangle] index into wall_names
  std::vector<std::string> region_names;
  std::vector<std::string> wall_names;
  std::string file;             ///< for messages; empty where the mesh was made here
  std::vector<int> cell_lines;  ///< [cell] line of the file that defines it; may be empty
  // What the file calls its points and cells, for messages; empty where it counts from 0.
  std::vector<std::int64_t> point_numbers;
  std::vector<std::int64_t> cell_numbers;
  ParentCells parents;  ///< of cells that were cut from others'
};

}  // namespace etendue
