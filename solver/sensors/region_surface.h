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

/// All faces between a region and what is not it.
std::vector<SurfaceFace> surface_of(const TetrahedralMesh& mesh, int region);

}  // namespace etendue
