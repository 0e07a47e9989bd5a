// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "base/vec3.h"
#include "solver/uncollided/rays/light_paths.h"

namespace etendue {

/// Straight line at which walls or surfaces between media end or meet at an angle. Behind it, seen from a
/// light, the light is discontinuous (the edge of a shadow) or its derivative is (attenuation by a medium).
struct ShadowEdge {
  /// One side of a surface that meets there.
  struct Surface {
    Vec3 normal;  ///< unit: of a wall out of the domain; else into the region of the higher number
    Vec3 away;    ///< unit: in the surface, across the shadow edge
    int wall;     ///< -1 between media
    std::pair<int, int> regions;  ///< that it parts
    bool mirrors;
  };
  Vec3 begin, end;
  std::vector<Surface> surfaces;
  bool blunt;  ///< all surfaces continue beyond it at a small angle
};

/// Returns each line once, also where it consists of many edges of the mesh.
std::vector<ShadowEdge> shadow_edges_of(const LightPaths& paths);

}  // namespace etendue
