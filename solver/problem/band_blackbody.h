// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/problem/bands.h"

namespace etendue {

/// Radiance of a blackbody in one band [W/(m^2 sr)] by its temperature [K], in media of the bands' refractive
/// index n: n^2 sigma T^4/pi (Modest, Radiative Heat Transfer, section 1.5) times the fraction
/// of its power that is between the band's edges [nm], or the weight of the band's gray gas. A single band
/// without edges has all. Beyond the temperatures that gray gases were fitted to their weights are those
/// of the nearest.
double band_blackbody(const Bands& bands, int band, double kelvin);

/// Its derivative by the temperature [W/(m^2 sr K)].
double band_blackbody_slope(const Bands& bands, int band, double kelvin);

/// Its derivative by the radiance n^2 sigma T^4/pi of all bands: the part of what a blackbody sends out more
/// that is in the band.
double band_share_of_change(const Bands& bands, int band, double kelvin);

}  // namespace etendue
