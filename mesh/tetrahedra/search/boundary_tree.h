// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// Where a ray from outside comes into the domain.
struct BoundaryEntry {
  FaceIndex face;
  Vec3 point;  ///< in that face, to rounding
};

/// The boundary faces in a binary tree of boxes, for rays that start outside of the domain.
class BoundaryTree {
 public:
  /// The mesh must outlive it.
  explicit BoundaryTree(const TetrahedralMesh& mesh);

  /// The nearest face that the ray passes from outside to inside; faces that it would leave by are not seen.
  /// Empty where there is none.
  std::optional<BoundaryEntry> first_entry(const Vec3& origin, const Vec3& direction) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box{};
    std::array<std::int32_t, 2> children{-1, -1};  ///< of a group
    std::int32_t first = 0;                        ///< of a leaf, in faces_
    std::int32_t last = 0;
  };
  std::int32_t build(std::int32_t first, std::int32_t last, std::span<const Vec3> centroids);

  const TetrahedralMesh& mesh_;
  std::vector<Node> nodes_;
  std::vector<std::int32_t> faces_;
};

}  // namespace etendue
