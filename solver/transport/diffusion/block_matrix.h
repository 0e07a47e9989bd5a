// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// One number for each of the four vertices of every cell, [cell][4].
using NodalVector = std::vector<double>;

/// The four values of one cell.
inline Eigen::Map<Eigen::Vector4d> nodes_of(std::span<double> values, std::size_t cell) {
  return Eigen::Map<Eigen::Vector4d>(&values[4 * cell]);
}
inline Eigen::Map<const Eigen::Vector4d> nodes_of(std::span<const double> values, std::size_t cell) {
  return Eigen::Map<const Eigen::Vector4d>(&values[4 * cell]);
}

/// A matrix on linear discontinuous elements: each cell is coupled to itself and to the cells behind its four
/// faces. Products are formed cell by cell, so they do not depend on the number of threads.
class BlockMatrix {
 public:
  using Block = Eigen::Matrix4d;

  explicit BlockMatrix(const TetrahedralMesh& mesh);

  int cell_count() const { return static_cast<int>(neighbours_.size()); }
  /// The cell behind face f, -1 at a wall.
  std::int32_t neighbour(CellIndex cell, std::size_t f) const { return neighbours_[cell.at()][f]; }
  Block& diagonal(CellIndex cell) { return blocks_[5 * cell.at()]; }
  const Block& diagonal(CellIndex cell) const { return blocks_[5 * cell.at()]; }
  /// Rows of this cell, columns of the one behind face f.
  Block& behind(CellIndex cell, std::size_t f) { return blocks_[5 * cell.at() + 1 + f]; }
  const Block& behind(CellIndex cell, std::size_t f) const { return blocks_[5 * cell.at() + 1 + f]; }

  /// y = A x
  void multiply(std::span<const double> x, std::span<double> y, int threads) const;
  /// y = b - A x
  void residual(std::span<const double> b, std::span<const double> x, std::span<double> y, int threads) const;

 private:
  Eigen::Vector4d row(std::size_t cell, std::span<const double> x) const;

  std::vector<std::array<std::int32_t, 4>> neighbours_;
  std::vector<Block, Eigen::aligned_allocator<Block>> blocks_;  ///< [cell][5]
};

}  // namespace etendue
