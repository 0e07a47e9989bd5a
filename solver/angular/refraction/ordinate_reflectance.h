// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/angular/sets/direction_set.h"
#include "solver/problem/problem.h"

namespace etendue {

/// [ordinate] Reflectance of a refracting wall, by the angle of the ordinate to the normal on either side.
///
/// By falling cosine mu the ordinates share the flux of the half range: each has a bin of mu^2 that
/// holds its w mu, and the mean of Fresnel's reflectance over this bin. The transmitted flux of isotropic
/// light is therefore that of the sphere, to rounding. The reflectance is then shifted within the cone, at
/// this flux, until the zeroth half-range moment of the transmitted light is right too, or as near as
/// reflectances between 0 and 1 bring it. Sets that are fitted_to_refraction have a bin's edge at the
/// critical angle.
std::vector<double> ordinate_reflectances(const DirectionSet& directions, const Wall& wall,
                                          const Vec3& normal);

}  // namespace etendue
