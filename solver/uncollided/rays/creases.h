// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "base/vec3.h"
#include "solver/uncollided/rays/light_paths.h"

namespace etendue {

/// A straight line at which the surfaces of a problem do not go on: where walls or surfaces between media
/// meet at an angle or end. Behind it, as a light sees it, lies the edge of a shadow, or a bend in what
/// matter has left of the light.
struct Crease {
  /// One side of a surface that meets there.
  struct Surface {
    Vec3 normal;  ///< unit: of a wall out of the domain; else into the region of the higher number
    Vec3 away;    ///< unit: in the surface, across the crease
    int wall;     ///< -1 between media
    std::pair<int, int> regions;  ///< that it parts
    bool mirrors;
  };
  Vec3 begin, end;
  std::vector<Surface> surfaces;
  bool blunt;  ///< whether all go on beyond it with hardly a bend
};

/// Each line once, however many edges of the mesh make it up.
std::vector<Crease> creases_of(const LightPaths& paths);

}  // namespace etendue
