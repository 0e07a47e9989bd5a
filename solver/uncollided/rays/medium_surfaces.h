// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/tetrahedra/search/face_tree.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// Surfaces where a straight path through the domain meets something else: those between media of constant
/// extinction and others, and the boundary where it is not convex. Between them a path needs no cells.
class MediumSurfaces {
 public:
  /// `medium` [cell]: the number of a medium of constant extinction, or `varying`. Where media change
  /// every few cells all count as varying. Without `whole_boundary` faces that have all of the domain on one
  /// side are left out: no path between two of its points crosses them. The mesh must outlive it.
  MediumSurfaces(const TetrahedralMesh& mesh, std::vector<std::int32_t> medium, bool whole_boundary);

  static constexpr std::int32_t varying = -1;
  std::int32_t medium(CellIndex cell) const { return medium_[cell.at()]; }

  /// What a path meets first within its length.
  struct Crossing {
    enum class Kind {
      none,
      surface,
      unclear  ///< it begins on a surface, or comes too near to an edge: cells tell where it goes
    } kind = Kind::none;
    double distance = 0;
    FaceIndex face = FaceIndex(0);
    bool exact = true;  ///< else it is another face of that wall or interface in the same plane
  };
  /// From a point of a constant medium along a unit vector; `through` is the face by which the path came in.
  Crossing first(const Vec3& from, const Vec3& direction, double length, std::int32_t medium,
                 std::optional<FaceIndex> through) const;

  /// How far a path that began on a surface has to be away before it is asked for again.
  double clear_distance() const { return 1000 * touching_; }
  /// The cell behind an interior face.
  CellIndex beyond(FaceIndex face, const Vec3& direction) const {
    return direction.dot(mesh_.area_normal(face)) > 0 ? mesh_.neighbour(face) : mesh_.owner(face);
  }

 private:
  const TetrahedralMesh& mesh_;
  std::vector<std::int32_t> medium_;
  double touching_;  ///< [length]
  FaceTree faces_;
};

}  // namespace etendue
