// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/diffusion/vertex_space.h"

namespace etendue {

VertexSpace::VertexSpace(const TetrahedralMesh& mesh)
    : vertices_(mesh.cell_vertices().begin(), mesh.cell_vertices().end()),
      first_(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0),
      nodes_(4 * vertices_.size()) {
  for (const auto& cell : vertices_)
    for (const std::int32_t v : cell) ++first_[static_cast<std::size_t>(v) + 1];
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t node = 0; node < nodes_.size(); ++node)
    nodes_[static_cast<std::size_t>(next[static_cast<std::size_t>(vertices_[node / 4][node % 4])]++)] =
        static_cast<std::int32_t>(node);
}

void VertexSpace::gather(std::span<const double> nodal, std::span<double> vertices) const {
  for (std::size_t v = 0; v + 1 < first_.size(); ++v) {
    double sum = 0;
    for (std::int32_t k = first_[v]; k < first_[v + 1]; ++k)
      sum += nodal[static_cast<std::size_t>(nodes_[static_cast<std::size_t>(k)])];
    vertices[v] = sum;
  }
}

void VertexSpace::add_spread(std::span<const double> vertices, std::span<double> nodal, int threads) const {
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t c = 0; c < vertices_.size(); ++c)
    for (std::size_t i = 0; i < 4; ++i)
      nodal[4 * c + i] += vertices[static_cast<std::size_t>(vertices_[c][i])];
}

Eigen::SparseMatrix<double> VertexSpace::assemble(
    const std::function<Eigen::Matrix4d(CellIndex)>& cell_matrix) const {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(10 * vertices_.size());
  for (std::size_t c = 0; c < vertices_.size(); ++c) {
    const Eigen::Matrix4d matrix = cell_matrix(CellIndex(static_cast<std::int64_t>(c)));
    // Vertices rise: entries below the diagonal stay there.
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        entries.emplace_back(vertices_[c][i], vertices_[c][j],
                             matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  }
  Eigen::SparseMatrix<double> result(size(), size());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace etendue
