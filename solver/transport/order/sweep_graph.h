// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/transport/order/sweep_slots.h"

namespace etendue {

/// Neighbors of all cells, packed as the visits of cells need them; shared by the sweep orders of all
/// directions. The orders are made again and again, so the layout is for speed.
class SweepGraph {
 public:
  /// Behind interior faces the other cell's number in place of the slot; behind boundary faces the inflow.
  struct alignas(16) Behind {
    std::array<std::uint32_t, 4> faces;
  };
  struct Faces {
    std::array<std::int32_t, 4> numbers;
    std::uint32_t owned = 0;     ///< bit k: the normal of face k points out of this cell
    std::uint32_t boundary = 0;  ///< bit k: face k lies on a wall
  };

  /// The mesh must outlive it. Throws InputError where it has more cells than a visit can name.
  explicit SweepGraph(const TetrahedralMesh& mesh);

  const TetrahedralMesh& mesh() const { return mesh_; }
  const WallSlots& walls() const { return walls_; }
  std::size_t cell_count() const { return behind_.size(); }
  const std::vector<Behind>& behind() const { return behind_; }  ///< [cell]
  const std::vector<Faces>& faces() const { return faces_; }     ///< [cell]

 private:
  const TetrahedralMesh& mesh_;
  WallSlots walls_;
  std::vector<Behind> behind_;
  std::vector<Faces> faces_;
};

}  // namespace etendue
