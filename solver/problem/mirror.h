// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/problem/problem.h"

namespace etendue {

/// The part of unpolarised light that a smooth surface reflects which it meets at `cosine` > 0 to the normal;
/// `index` is the refractive index on the side of the light over that behind the surface. 1 where it is
/// reflected totally (Fresnel's formulas; Born and Wolf 1999, section 1.5.2).
double fresnel_reflectance(double cosine, double index);

/// Cosine to the normal below which a surface reflects all light; 0 where the index is at most 1.
double critical_cosine(double index);

/// Integral of mu^power (1 - R) dmu over the cosines mu from 0 to `cosine`, R = fresnel_reflectance(mu,
/// index): moments of the light that is transmitted, to 1e-10.
double transmitted_moment(double cosine, int power, double index);

/// Returns whether a wall mirrors in some band: by its specular reflectance or because it refracts.
bool is_mirror(const Wall& wall);
/// The part of light that a wall mirrors which it meets at `cosine` > 0 to the normal.
double mirrored_part(const Wall& wall, std::size_t band, double cosine);
/// The part of isotropic light that a wall mirrors.
double mirrored_part_of_isotropic(const Wall& wall, std::size_t band);
/// The radiance that a wall's `radiance` sends in at `cosine` > 0 to the normal.
double radiance_sent(const Wall& wall, std::size_t band, double cosine);
/// Irradiance that a wall's radiance gives, over that of the same radiance just inside: 1, or what
/// a surface that refracts lets in and draws together.
double entering_part(const Wall& wall);

}  // namespace etendue
