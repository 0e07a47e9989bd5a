// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/problem/sky/perez_sky.h"

namespace etendue {

/// Of the atmosphere where it is not measured [cm], as gendaylit (Radiance) assumes: a dew point of 11
/// degrees Celsius.
inline constexpr double usual_precipitable_water = 2;

/// Luminous efficacy of the light of a sky on a level plane [lm/W], of all wavelengths together, with the sun
/// at a zenith angle below pi/2 [rad]: a + b W + c cos(Z) + d ln(Delta) with the precipitable water W (Perez
/// et al., Solar Energy 44 (1990) 271, eq. (7) and table 4).
double diffuse_luminous_efficacy(const SkyConditions& conditions, double sun_zenith,
                                 double precipitable_water = usual_precipitable_water);

}  // namespace etendue
