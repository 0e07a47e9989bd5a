// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// Continuous linear functions on a mesh, one value for each vertex, inside the discontinuous ones.
class VertexSpace {
 public:
  explicit VertexSpace(const TetrahedralMesh& mesh);

  int size() const { return static_cast<int>(first_.size()) - 1; }
  /// Adds up what the cells around each vertex have there: the transpose of `spread`.
  void gather(std::span<const double> nodal, std::span<double> vertices) const;
  /// Adds each vertex's value at that vertex of all cells around it.
  void add_spread(std::span<const double> vertices, std::span<double> nodal, int threads) const;
  /// Lower triangle of the matrix of a form that is given cell by cell.
  Eigen::SparseMatrix<double> assemble(const std::function<Eigen::Matrix4d(CellIndex)>& cell_matrix) const;

 private:
  std::vector<std::array<std::int32_t, 4>> vertices_;  ///< [cell]
  std::vector<std::int32_t> first_;                    ///< [vertex] into nodes_
  std::vector<std::int32_t> nodes_;                    ///< 4 cell + node, around each vertex, rising
};

}  // namespace etendue
