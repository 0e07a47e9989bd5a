// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/problem/lights/light.h"

namespace etendue {

/// Light of the tip of a fibre, which fills a cone about the axis with the same radiance in all directions
/// (and, over the tip, that of the beam's profile), as parallel beams of equal power: 128 directions whose
/// sines lie on a sunflower's spiral in the disc of the cone, so that each has the same part of the
/// projected solid angle (H. Vogel, Math. Biosci. 44 (1979) 179). `beam` is the light with all of its power
/// along the axis, its profile that of the tip, `numerical_aperture` the sine of the half angle of the cone.
std::vector<BeamLight> fibre_parts(const BeamLight& beam, double numerical_aperture);

}  // namespace etendue
