// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/diffusion/block_matrix.h"

namespace etendue {

BlockMatrix::BlockMatrix(const TetrahedralMesh& mesh)
    : neighbours_(static_cast<std::size_t>(mesh.cell_count())),
      blocks_(5 * neighbours_.size(), Block::Zero()) {
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (std::size_t f = 0; f < 4; ++f) {
      const auto& sides = mesh.face_cells()[static_cast<std::size_t>(mesh.faces(CellIndex(c))[f])];
      neighbours_[static_cast<std::size_t>(c)][f] = sides[0] == c ? sides[1] : sides[0];
    }
}

Eigen::Vector4d BlockMatrix::row(std::size_t cell, std::span<const double> x) const {
  const Block* blocks = &blocks_[5 * cell];
  Eigen::Vector4d sum = blocks[0] * nodes_of(x, cell);
  for (std::size_t f = 0; f < 4; ++f) {
    const std::int32_t neighbour = neighbours_[cell][f];
    if (neighbour >= 0) sum.noalias() += blocks[1 + f] * nodes_of(x, static_cast<std::size_t>(neighbour));
  }
  return sum;
}

void BlockMatrix::multiply(std::span<const double> x, std::span<double> y, int threads) const {
  const std::size_t cells = neighbours_.size();
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t c = 0; c < cells; ++c) nodes_of(y, c) = row(c, x);
}

void BlockMatrix::residual(std::span<const double> b, std::span<const double> x, std::span<double> y,
                           int threads) const {
  const std::size_t cells = neighbours_.size();
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t c = 0; c < cells; ++c) nodes_of(y, c) = nodes_of(b, c) - row(c, x);
}

}  // namespace etendue
