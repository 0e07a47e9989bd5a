// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "base/vec3.h"

namespace etendue {

/// Irradiance that a flat polygon of radiance 1 brings to the origin, on the side that the unit vector
/// `normal` points to: the solid angle of the part above the horizon, projected on the meter's plane [sr].
/// Lambert (1760), in the vector form
///
///     E = |sum over the edges of a_i (x_i cross x_j).n / (2 |x_i cross x_j|)|,   a_i the angle of the edge.
///
/// Corners in order, either way round; a polygon whose plane holds the origin brings
/// nothing, but must not be asked for where that plane is the meter's own.
double polygon_irradiance(std::span<const Vec3> corners, const Vec3& normal);

/// Solid angle of a triangle seen from the origin [sr] (van Oosterom and Strackee 1983, eq. 8).
double triangle_solid_angle(const std::array<Vec3, 3>& corners);

}  // namespace etendue
