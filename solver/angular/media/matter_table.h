// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "solver/angular/sets/direction_set.h"
#include "solver/materials/kernels/directional_scattering.h"

namespace etendue {

/// Writes where a medium whose coefficients depend on the direction scatters light of each incident direction
/// w': P_m(w') - 1/(4 pi) [1/sr], [ordinate][incident], with P_m(w') = k(w' -> w_m) over its sum over the
/// set, so that the power is kept. Directions of which nothing is scattered are left alone.
void tabulate_matter(const DirectionalScattering& scattering, std::span<const Vec3> incident,
                     const DirectionSet& directions, int threads, std::span<double> table);

}  // namespace etendue
