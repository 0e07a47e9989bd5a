// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>

#include "solver/problem/sky/sky_shape.h"

namespace etendue {

/// Sky conditions of Perez et al., of all wavelengths together.
struct SkyConditions {
  double clearness;   ///< epsilon, from 1 (overcast) to about 12 (clear)
  double brightness;  ///< Delta
};

/// Classes of clearness, from overcast to clear (Perez et al. 1990, table 1).
inline constexpr std::size_t clearness_bins = 8;
std::size_t clearness_bin(double clearness);

/// Conditions of a direct normal and a diffuse horizontal irradiance [W/m^2] with the sun at a zenith angle
/// below pi/2 [rad] (Perez et al., Solar Energy 44 (1990) 271, eqs. (1) and (2)); the air mass is Kasten's
/// (1966). `eccentricity` is the square of the mean over the present distance of the sun.
SkyConditions sky_conditions(double direct_normal, double diffuse_horizontal, double sun_zenith,
                             double eccentricity = 1);

/// The all-weather model (Perez, Seals and Michalsky, Solar Energy 50 (1993) 235, with the erratum 51 (1993)
/// 423).
SkyShape perez_sky(const SkyConditions& conditions, double sun_zenith);

}  // namespace etendue
