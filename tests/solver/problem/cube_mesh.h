// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// The unit cube in six tetrahedra around a diagonal (Kuhn 1960). Region "left" holds the three where
/// x <= y, "right" the others; wall "floor" is z = 0, "rest" the other sides.
inline TetrahedralMesh cube_mesh() {
  RawMesh raw;
  for (int i = 0; i < 8; ++i) raw.points.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  raw.region_names = {"left", "right"};
  raw.wall_names = {"floor", "rest"};
  std::array<int, 3> axes = {0, 1, 2};
  do {  // from corner 0 to corner 7 along the axes in every order
    const std::array<int, 4> cell = {0, 1 << axes[0], (1 << axes[0]) | (1 << axes[1]), 7};
    const bool even = (axes[1] - axes[0] + 3) % 3 == 1;  // cyclic orders make positive volumes
    raw.cells.push_back(even ? cell : std::array{cell[0], cell[2], cell[1], cell[3]});
    const auto step = [&axes](int axis) { return std::find(axes.begin(), axes.end(), axis); };
    raw.cell_regions.push_back(step(0) < step(1) ? 1 : 0);
    for (const std::array<int, 3>& triangle :
         {std::array{cell[0], cell[1], cell[2]}, std::array{cell[1], cell[2], cell[3]}}) {
      const bool floor = std::all_of(triangle.begin(), triangle.end(), [](int v) { return (v & 4) == 0; });
      raw.triangles.push_back(triangle);
      raw.triangle_walls.push_back(floor ? 0 : 1);
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return TetrahedralMesh(raw);
}

}  // namespace etendue
