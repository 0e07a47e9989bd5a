// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "solver/angular/refraction/smooth_planes.h"
#include "solver/angular/sets/direction_set.h"

namespace etendue {

/// The directions of a set with weights for refracting planes.
///
/// At a surface to an optically thinner medium light is reflected totally from the critical angle on, and
/// the radiance has an edge there that a set's weights know nothing of. Here they are multiplied by factors
/// 1 + f, with the smallest mean square of f, such that
///
/// * the moments of degree 0 and 1 of the cosine to each normal are exact in the cone within the critical
///   angle and outside of it (so are the half ranges),
/// * the moments of degree 2 of all directions stay exact and the half ranges along x, y and z as they are,
/// * and, where factors of at least 0.2 allow it, the moments of degree 4 stay as they are and those of
/// degree
///   2 in and outside the cones are exact.
///
/// Ordinates that are mirror images keep equal weights. A plane whose moments positive weights cannot match
/// (too few directions in its cone), or whose mirror images are not in the set, is left out.
DirectionSet fitted_to_refraction(const DirectionSet& set, std::span<const SmoothPlane> planes);

/// Returns true where the flux of some of the ordinates is that of the cone within a plane's critical angle,
/// as on fitted sets, and where nothing is reflected totally.
bool parts_at_critical_angle(const DirectionSet& set, const SmoothPlane& plane);

}  // namespace etendue
