// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// The edges between some vertices of a mesh, found by their ends.
class MeshEdges {
 public:
  struct Edge {
    std::int32_t first, second;  ///< vertices, first < second
    CellIndex cell;              ///< the first of the cells around it
  };

  MeshEdges() = default;
  /// Edges of cells between vertices that are wanted, `wanted(std::int32_t)`, sorted by their ends.
  template <class Wanted>
  MeshEdges(const TetrahedralMesh& mesh, const Wanted& wanted) {
    for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
      const auto& vertices = mesh.vertices(CellIndex(c));
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j)
          if (wanted(vertices[i]) && wanted(vertices[j])) add(vertices[i], vertices[j], CellIndex(c));
    }
    sort();
  }

  std::size_t size() const { return edges_.size(); }
  const Edge& operator[](std::size_t i) const { return edges_[i]; }
  /// The number of the edge between two vertices, in any order, that has to be there.
  std::size_t between(std::int32_t a, std::int32_t b) const;

 private:
  void add(std::int32_t a, std::int32_t b, CellIndex cell);
  void sort();

  std::vector<Edge> edges_;
};

}  // namespace etendue
