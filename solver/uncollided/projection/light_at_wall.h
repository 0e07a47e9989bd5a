// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/uncollided/rays/shadow_edges.h"
#include "solver/uncollided/sources/light_source.h"

namespace etendue {

/// Part of the power of a source that reaches a wall from within before its first collision, in the band in
/// which that part is largest.
double part_at_wall(const LightPaths& paths, const std::vector<ShadowEdge>& shadow_edges,
                    const LightSource& source, const Wall& wall);

}  // namespace etendue
