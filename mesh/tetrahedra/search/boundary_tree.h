// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "mesh/tetrahedra/search/face_tree.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// Where a ray from outside comes into the domain.
struct BoundaryEntry {
  FaceIndex face;
  Vec3 point;  ///< in that face, to rounding
};

/// The boundary faces, for rays that start outside of the domain.
class BoundaryTree {
 public:
  explicit BoundaryTree(const TetrahedralMesh& mesh);

  /// The nearest face that the ray passes from outside to inside; faces that it would leave by are not seen.
  /// Empty where there is none.
  std::optional<BoundaryEntry> first_entry(const Vec3& origin, const Vec3& direction) const;

 private:
  double touching_;  ///< [length]
  FaceTree faces_;
};

}  // namespace etendue
