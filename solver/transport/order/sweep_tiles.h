// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// The tiles of a mesh: boxes of neighbouring cells, so few that what a sweep reads and writes of them stays
/// in the cache while one ordinate after the other passes.
class SweepTiles {
 public:
  /// Tiles of at most `most_cells`, by halving boxes across their longest sides.
  SweepTiles(const TetrahedralMesh& mesh, std::size_t most_cells);

  std::int32_t count() const { return static_cast<std::int32_t>(splits_.size()) + 1; }
  std::int32_t of_cell(std::size_t cell) const { return of_cell_[cell]; }
  /// [step] The tiles in the order in which light of a direction's octant passes them, which is that of the
  /// opposite octant backwards. A cell is visited in the step of its tile, or in the first later one in which
  /// it has all that it waits for.
  std::vector<std::int32_t> along(const Vec3& direction) const;

 private:
  /// A box that was halved. Its parts are other splits, or tiles t as -1 - t.
  struct Split {
    int axis;
    std::int32_t lower;
    std::int32_t upper;
  };

  class Halving;
  void add_along(const Vec3& direction, std::int32_t part, std::vector<std::int32_t>& sequence) const;

  std::vector<std::int32_t> of_cell_;
  std::vector<Split> splits_;
  std::int32_t root_ = 0;
};

/// The most cells of a tile, where a visit reads and writes `cell_bytes` of each of all `cells`: all of them
/// where `cache_bytes` hold them.
std::size_t cells_per_tile(std::size_t cells, std::size_t cell_bytes, std::size_t cache_bytes);

}  // namespace etendue
