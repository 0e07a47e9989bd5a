// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "base/vec3.h"

namespace etendue {

using Box = Eigen::AlignedBox3d;

/// A uniform grid over many axis-aligned boxes that says which of them a point may lie in. Grid cells that
/// many boxes share, as around the fine details of a large domain, have a grid of their own.
class BoxGrid {
 public:
  /// Boxes are taken larger by `margin` on all sides [length].
  BoxGrid(std::span<const Box> boxes, double margin);

  /// The numbers, rising, of the boxes that share a grid cell with the point: all boxes that hold it, and
  /// others. Empty outside.
  std::span<const std::int32_t> candidates(const Vec3& point) const;

 private:
  using Cell = Eigen::Vector3i;

  BoxGrid() = default;

  /// Cells for so many boxes within the bounds.
  void set_cells(std::size_t boxes);
  /// Items that the boxes with the numbers `boxes` would be.
  std::size_t copies(std::span<const Box> all, std::span<const std::int32_t> boxes) const;
  void fill(std::span<const Box> all, std::span<const std::int32_t> boxes);
  void divide_crowded_cells(std::span<const Box> all, int depth, std::size_t& room);
  Box box_of(const Cell& cell) const;
  std::span<const std::int32_t> items(std::size_t cell) const;
  Cell cell_of(const Vec3& point) const;
  std::size_t index(int i, int j, int k) const;

  Box bounds_;
  Cell counts_ = Cell::Ones();
  Vec3 per_length_ = Vec3::Zero();   ///< [1/length] grid cells
  std::vector<std::int32_t> first_;  ///< [grid cell] start in items_, one more at the end
  std::vector<std::int32_t> items_;
  std::vector<std::size_t> crowded_;  ///< grid cells that many boxes share, rising
  std::vector<BoxGrid> finer_;        ///< [crowded cell]
};

}  // namespace etendue
