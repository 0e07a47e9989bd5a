// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/lights/light_source.h"

namespace etendue {

/// The light at a vertex of a cell with this centroid, looked at coarsely: what arrives; in the dark what
/// would arrive without obstacles; in the plane of a flat light what arrives beside it.
void look_at_vertex(const LightSource& source, const PointInCell& here, const Vec3& centroid,
                    LightBeams& beams);

}  // namespace etendue
