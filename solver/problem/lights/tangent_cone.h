// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <numbers>
#include <vector>

#include "mesh/tetrahedra/search/cell_locator.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// The tangent cone of the domain at a point: the directions that lead from there into the domain. From a
/// point inside the domain, or on a sheet, all do; from a point on a flat wall those of a half space; from a
/// point on an edge or in a corner of the walls those of the part of space that the domain fills there.
class TangentCone {
 public:
  /// Of the whole sphere.
  TangentCone() = default;
  /// `cells` are those that hold the point, as CellLocator::find gives them.
  TangentCone(const TetrahedralMesh& mesh, const std::vector<CellPoint>& cells);

  /// Returns whether all directions lead into the domain.
  bool is_whole() const { return parts_.empty(); }
  bool contains(const Vec3& direction) const;
  double solid_angle() const { return solid_angle_; }  ///< [sr]

  /// The convex cone of one cell: directions with n.w >= 0 for each of these inward unit normals. There are
  /// at most three.
  using Part = std::vector<Vec3>;
  /// The cones of the cells at the point, which do not overlap; empty where the cone is whole.
  const std::vector<Part>& parts() const { return parts_; }

 private:
  std::vector<Part> parts_;
  double solid_angle_ = 4 * std::numbers::pi;
};

}  // namespace etendue
