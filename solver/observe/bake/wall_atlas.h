// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "solver/observe/bake/wall_bake.h"

namespace etendue {

/// The walls laid out in a square picture: each flat part, as its triangles hang together, is a chart, turned
/// and moved but not stretched, all to one scale.
struct WallAtlas {
  int side = 0;      ///< texels across and down
  double texel = 0;  ///< side of one [length]
  /// [vertex of the surface] place in the picture, from 0 to 1 across and down, as glTF has them
  std::vector<std::array<double, 2>> coordinates;
  /// Those that show a wall, and the next ones around, which repeat its edge so that textures are filtered
  /// without seams: row * side + column of each, and where it is.
  std::vector<std::size_t> texels;
  std::vector<BakePlace> places;
};

/// Throws InputError where the flat parts are too many for a picture of this side.
WallAtlas wall_atlas(const WallSurface& surface, const TetrahedralMesh& mesh, int side);

}  // namespace etendue
