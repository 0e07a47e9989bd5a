// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"

namespace etendue {

/// Radiance of a blackbody in one band [W/(m^2 sr)] by its temperature [K]: sigma T^4/pi times the fraction
/// of the power between the edges of the band (Modest, Radiative Heat Transfer, eqs. (1.21) and (1.24)).
/// Without edges the band holds all wavelengths, or the fraction of its gray gas. A formula where the
/// temperature is one.
Value blackbody_radiance(const Value& temperature, const Bands& bands, int band);

/// Fraction of the power of a blackbody of this temperature [K] that is in none of the bands.
double fraction_outside_bands(double kelvin, const Bands& bands);

}  // namespace etendue
