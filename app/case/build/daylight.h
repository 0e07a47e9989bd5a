// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "app/case/case.h"
#include "app/case/keys/value_check.h"

namespace etendue {

/// Reports every sensor with `daylight_factor` in a case whose light is not that of one sky alone: sunlight
/// is excluded from a daylight factor, and light of lamps is no daylight.
void check_daylight_factors(const Case& input, Faults& faults);

/// Irradiance [band] that a sun or a sky brings to an unobstructed level plane, without glazing
/// [power/length^2]: of a sky the integral of L cos(zenith angle) over the upper hemisphere, its zenith being
/// opposite to the light's `direction`.
std::vector<double> unobstructed_irradiance(const LightCase& light);

/// That of the sky of a case, which must have passed check_daylight_factors().
std::vector<double> unobstructed_sky_irradiance(const Case& input);

}  // namespace etendue
