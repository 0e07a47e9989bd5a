// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// A face of a region's surface, and on which side the region is.
struct SurfaceFace {
  FaceIndex face;
  CellIndex inside;
  std::optional<CellIndex> outside;  ///< empty: a wall
  Vec3 area;                         ///< out of the region [length^2]
};

/// What lies beyond a part of a region's surface: a region or a wall; with neither, whatever there is.
struct Beyond {
  int region = -1;
  int wall = -1;
};

/// The faces between a region and what is not it, or that part of them.
std::vector<SurfaceFace> surface_of(const TetrahedralMesh& mesh, int region, const Beyond& beyond = {});

/// The inner side of a whole wall.
std::vector<SurfaceFace> surface_of_wall(const TetrahedralMesh& mesh, int wall);

}  // namespace etendue
