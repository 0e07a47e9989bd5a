// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/lights/crease_planes.h"
#include "solver/lights/nodal_moments.h"

namespace etendue {

/// Adds the irradiance that a source brings to a boundary face from the domain. Near a point light it is
/// integrated over the solid angle of the face: the integral of shape E dA is P times that of
/// i(w) T shape dw. Creases part the face.
void add_irradiance(const LightPaths& paths, const LightSource& source, const CreasePlanes& creases,
                    FaceIndex face, LightBeams& beams, NodalMoments& moments);

}  // namespace etendue
