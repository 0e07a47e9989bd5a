// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/angle/direction_set.h"
#include "solver/problem/problem.h"

namespace etendue {

/// [ordinate] What a wall that refracts reflects of an ordinate, by its angle to the normal, either way: the
/// mean r of Fresnel's reflectance over a cone of its weight, since total reflection may begin within, moved
/// by c r (1 - r) so that of isotropic light as much is reflected as on the whole sphere (as far as |c| <= 1
/// goes).
std::vector<double> ordinate_reflectances(const DirectionSet& directions, const Wall& wall,
                                          const Vec3& normal);

}  // namespace etendue
