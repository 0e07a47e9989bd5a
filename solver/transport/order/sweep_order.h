// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/transport/order/sweep_graph.h"
#include "solver/transport/order/sweep_tiles.h"

namespace etendue {

/// A face whose two sides do not wait for each other, because waiting would close a cycle: the cell behind it
/// reads what the cell before it held before this sweep.
struct LaggedFace {
  std::int32_t face = 0;
  /// The slots of the cells on its two sides, and the face as these see it. Light goes from the first to the
  /// second along the direction of the order, the other way along the opposite one.
  FaceCode upwind;
  FaceCode downwind;
};

/// The order in which one direction visits the cells. The opposite direction uses the same order backwards.
struct SweepOrder {
  std::span<const SweepVisit> visits;  ///< [position], in memory of whoever asked for the order
  std::vector<std::int32_t> levels;    ///< first position of each level of independent cells, and the end
  std::vector<std::int32_t> steps;     ///< first level of each step, in which one tile is opened, and the end
  std::vector<LaggedFace> lagged;
  std::uint32_t slot_count = 0;
};

/// Which cells of a level stand side by side: neighbours in space, or those through whose faces light goes
/// the same way, for kernels that leave out the faces through which none enters.
enum class LevelOrder { neighbours, alike };

/// Makes the orders of one direction after the other, with the same scratch memory.
class SweepOrderMaker {
 public:
  /// The arguments must outlive it.
  SweepOrderMaker(const SweepGraph& graph, const SweepTiles& tiles, LevelOrder levels);
  ~SweepOrderMaker();

  /// The order for one direction. Every cell stands behind all cells that send light into it, but for lagged
  /// faces (Tarjan's components, then a greedy feedback arc set; none is expected on Delaunay meshes).
  /// `visits` has room for one of each cell, and becomes part of the order.
  SweepOrder make(const Vec3& direction, std::span<SweepVisit> visits);

 private:
  struct Memory;

  const TetrahedralMesh& mesh_;
  std::unique_ptr<Memory> memory_;
};

}  // namespace etendue
