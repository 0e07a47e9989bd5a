// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "app/case/case.h"
#include "solver/problem/lights/light.h"

namespace etendue {

/// The parts of a sky that a table describes, some 10 degrees wide: each a beam that comes in by the walls
/// and has the light of its solid angle.
std::vector<BeamLight> sky_parts(const LightCase& light, const std::vector<int>& walls);

/// The parts of a sky of even radiance before a wall: rings about the normal of the wall, which bring to it
/// exactly pi times the radiance. `inwards` is that normal.
std::vector<BeamLight> even_sky_parts(const LightCase& light, const Vec3& inwards,
                                      const std::vector<int>& walls);

}  // namespace etendue
