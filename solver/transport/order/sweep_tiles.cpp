// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/order/sweep_tiles.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

namespace etendue {
namespace {

/// Part of the third-level cache for a tile, beside the slots of a group; smaller tiles, which the second
/// level would hold, have more cells at their edges, whose slots stay taken. Not asked of the machine,
/// because the order of visits decides the order of sums.
constexpr std::size_t tile_bytes = std::size_t{2} << 20;

/// Below this many cells too few of a tile are ready at a time.
constexpr std::size_t smallest_tile = 256;

}  // namespace

std::size_t cells_per_tile(std::size_t cells, std::size_t cell_bytes, std::size_t cache_bytes) {
  if (cells * cell_bytes <= cache_bytes) return cells;
  return std::max(smallest_tile, tile_bytes / cell_bytes);
}

class SweepTiles::Halving {
 public:
  Halving(const TetrahedralMesh& mesh, std::size_t most_cells_of_tile, SweepTiles& tiles)
      : most_cells_(most_cells_of_tile), tiles_(tiles) {
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c) points_.push_back(mesh.centroid(CellIndex(c)));
  }

  /// The split or tile that the cells become.
  std::int32_t halve(std::span<std::int32_t> cells) {
    if (cells.size() <= most_cells_) {
      for (const std::int32_t c : cells) tiles_.of_cell_[static_cast<std::size_t>(c)] = tile_count_;
      return -1 - tile_count_++;
    }
    const int axis = longest_axis(cells);
    const std::size_t half = cells.size() / 2;
    std::nth_element(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(half), cells.end(),
                     [&](std::int32_t a, std::int32_t b) {
                       return std::pair(point(a)[axis], a) < std::pair(point(b)[axis], b);
                     });
    const std::size_t at = tiles_.splits_.size();
    tiles_.splits_.push_back({axis, 0, 0});
    const std::int32_t lower = halve(cells.first(half));
    const std::int32_t upper = halve(cells.subspan(half));
    tiles_.splits_[at].lower = lower;
    tiles_.splits_[at].upper = upper;
    return static_cast<std::int32_t>(at);
  }

 private:
  const Vec3& point(std::int32_t cell) const { return points_[static_cast<std::size_t>(cell)]; }

  int longest_axis(std::span<const std::int32_t> cells) const {
    Vec3 low = point(cells[0]), high = low;
    for (const std::int32_t c : cells) {
      low = low.cwiseMin(point(c));
      high = high.cwiseMax(point(c));
    }
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    return static_cast<int>(axis);
  }

  std::size_t most_cells_;
  SweepTiles& tiles_;
  std::int32_t tile_count_ = 0;
  std::vector<Vec3> points_;
};

SweepTiles::SweepTiles(const TetrahedralMesh& mesh, std::size_t most_cells_of_tile)
    : of_cell_(static_cast<std::size_t>(mesh.cell_count())) {
  std::vector<std::int32_t> cells(of_cell_.size());
  std::iota(cells.begin(), cells.end(), 0);
  root_ = Halving(mesh, most_cells_of_tile, *this).halve(cells);
}

std::vector<std::int32_t> SweepTiles::along(const Vec3& direction) const {
  std::vector<std::int32_t> sequence;
  add_along(direction, root_, sequence);
  return sequence;
}

// Light that goes up along the axis of a split passes its lower part before its upper one, wherever it comes
// from.
void SweepTiles::add_along(const Vec3& direction, std::int32_t part,
                           std::vector<std::int32_t>& sequence) const {
  if (part < 0) {
    sequence.push_back(-1 - part);
    return;
  }
  const Split& split = splits_[static_cast<std::size_t>(part)];
  const bool upwards = direction[split.axis] > 0;
  add_along(direction, upwards ? split.lower : split.upper, sequence);
  add_along(direction, upwards ? split.upper : split.lower, sequence);
}

}  // namespace etendue
