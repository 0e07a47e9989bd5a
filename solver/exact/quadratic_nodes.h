// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// The nodes at which a function is sampled to be projected: vertices, by their number, then the midpoints of
/// edges. Values at them make a quadratic function in each cell, and its projection is the best linear one in
/// the sense of L2. Its mean is that of the quadratic: off by O(h^4) of a smooth function, where that of the
/// values at the vertices is off by O(h^2).
class QuadraticNodes {
 public:
  /// The mesh must outlive the nodes.
  explicit QuadraticNodes(const TetrahedralMesh& mesh);

  std::size_t count() const { return static_cast<std::size_t>(mesh_.vertex_count()) + middles_.size(); }
  const Vec3& point(std::size_t node) const;
  /// Its vertices, then the midpoints of the edges 01, 02, 03, 12, 13, 23.
  std::array<std::size_t, 10> nodes(CellIndex cell) const;
  /// Of a boundary face: its vertices, then the midpoints of the edges 01, 02, 12.
  std::array<std::size_t, 6> nodes(FaceIndex face) const;

 private:
  const TetrahedralMesh& mesh_;
  std::vector<Vec3> middles_;
  std::vector<std::array<std::int32_t, 6>> edges_;  ///< [cell]
};

/// The values at the vertices of the linear function nearest to a quadratic one in L2.
std::array<double, 4> project(const std::array<double, 10>& values);
std::array<double, 3> project(const std::array<double, 6>& values);

}  // namespace etendue
