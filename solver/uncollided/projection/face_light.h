// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/uncollided/moments/nodal_moments.h"
#include "solver/uncollided/sources/shadow_planes.h"

namespace etendue {

/// Adds the irradiance that a source brings to a boundary face from the domain. Near a point light it is
/// integrated over the solid angle of the face: the integral of shape E dA is P times that of
/// i(w) T shape dw. The face is divided along shadow planes.
void add_irradiance(const LightPaths& paths, const LightSource& source, const ShadowPlanes& shadows,
                    FaceIndex face, LightBeams& beams, NodalMoments& moments);

}  // namespace etendue
