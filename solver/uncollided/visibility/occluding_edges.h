// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "solver/uncollided/rays/shadow_edges.h"
#include "solver/uncollided/sources/extended_source.h"

namespace etendue {

/// Edges of walls that may be between a flat light and a cell or face: places behind them lie in its
/// penumbra. May be used by several threads at a time.
class OccludingEdges {
 public:
  /// Without any for lights that are not flat, and where edges are too many to be tested for each of them.
  OccludingEdges(const LightPaths& paths, const ExtendedSource& source,
                 const std::vector<ShadowEdge>& shadow_edges);

  /// Those that reach into the convex hull of the light and of these corners; via mirrors into that of
  /// the light and of the corners' images behind them.
  std::vector<ShadowEdge> before(std::span<const Vec3> corners) const;

 private:
  /// An edge as it stands behind mirrors.
  struct Copy {
    std::size_t number;
    Vec3 begin, end;
    Eigen::AlignedBox3d box;
  };
  struct Image {
    MirrorSet mirrors;
    std::vector<Copy> edges;
  };

  const MirrorPlanes& planes_;
  std::vector<ShadowEdge> shadow_edges_;
  std::vector<Vec3> light_;  ///< its hull is that of these points, or somewhat smaller
  std::vector<Image> images_;
};

/// Test of a segment against the convex hull of at least four points: true where it reaches in by more than
/// this distance. By the theorem of the separating axis (Gottschalk, Lin, Manocha 1996) with the normals of
/// all triangles of the points and the cross products of the segment and their differences.
bool reaches_into(const Vec3& begin, const Vec3& end, std::span<const Vec3> hull, double distance);

}  // namespace etendue
