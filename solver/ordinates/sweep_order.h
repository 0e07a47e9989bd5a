// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// A face whose two sides do not wait for each other, because waiting would close a cycle: the cell behind it
/// reads what the cell before it sent in the last sweep.
struct LaggedFace {
  std::int32_t face = 0;
  std::int32_t upwind_slot = 0;    ///< written by the cell that the light leaves
  std::int32_t downwind_slot = 0;  ///< read by the cell that the light enters
};

/// The order in which one direction visits the cells, and where each cell finds and leaves the traces on its
/// faces. The opposite direction uses the same order backwards.
///
/// Slot 0 belongs to faces parallel to the direction, through which nothing passes. Slot 1 + f belongs to
/// boundary face f. Then come two for each lagged face, and the rest are used again as soon as the cell
/// behind a face has read it: they stay in cache.
struct SweepOrder {
  std::vector<std::int32_t> cells;   ///< [position] cell
  std::vector<std::int32_t> slots;   ///< [position][4] slot of each face of that cell
  std::vector<std::int32_t> levels;  ///< first position of each level of independent cells, and the end
  std::vector<LaggedFace> lagged;
  std::int32_t slot_count = 0;

  std::size_t bytes() const {
    return (cells.size() + slots.size() + levels.size()) * sizeof(std::int32_t) +
           lagged.size() * sizeof(LaggedFace);
  }
};

/// A face with |w.n| below this is parallel to the direction, on both sides.
inline constexpr double parallel_cosine = 1e-14;

/// Area of a face seen along a direction, w . (A n) [length^2]; exactly zero where they are parallel.
inline double seen_area(const Vec3& area_normal, const Vec3& direction) {
  const double a = direction.dot(area_normal);
  // Squares instead of a root: this is asked of all faces for every direction.
  return a * a < parallel_cosine * parallel_cosine * area_normal.squaredNorm() ? 0 : a;
}

/// The order for one direction. Every cell stands behind all cells that send light into it, but for lagged
/// faces (Tarjan's components, then a greedy feedback arc set; none is expected on Delaunay meshes).
SweepOrder make_sweep_order(const TetrahedralMesh& mesh, const Vec3& direction);

}  // namespace etendue
