// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// A cell that holds a point, and the point's barycentric coordinates there, in the order of its vertices.
struct CellPoint {
  CellIndex cell;
  std::array<double, 4> barycentric;
};

/// Finds the cells that a point lies in.
class CellLocator {
 public:
  /// The mesh must outlive the locator.
  explicit CellLocator(const TetrahedralMesh& mesh);
  ~CellLocator();
  CellLocator(CellLocator&&) noexcept;
  CellLocator& operator=(CellLocator&&) noexcept;

  /// All cells that hold the point to within 1e-9 of the domain's size, by rising number; empty outside.
  std::vector<CellPoint> find(const Vec3& point) const;

 private:
  struct Grid;
  std::unique_ptr<Grid> grid_;
};

}  // namespace etendue
