// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "mesh/tetrahedra/search/boundary_tree.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "solver/uncollided/rays/light_paths.h"

namespace etendue {

/// Where rays of a camera begin in the mesh.
class RayEntry {
 public:
  /// The mesh must outlive it.
  explicit RayEntry(const TetrahedralMesh& mesh) : mesh_(mesh), locator_(mesh), boundary_(mesh) {}

  /// A point of a cell where the ray starts, or where it comes in through the back of a wall; empty where it
  /// meets nothing.
  std::optional<PointInCell> enter(const Vec3& origin, const Vec3& direction) const;

 private:
  const TetrahedralMesh& mesh_;
  CellLocator locator_;
  BoundaryTree boundary_;
};

}  // namespace etendue
