// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// Corners of a flat polygon, counterclockwise seen from the side that its normal points to.
using Corners = std::span<const Vec3>;
using TriangleCorners = std::array<Vec3, 3>;

/// The part of a convex polygon where normal.x >= offset.
std::vector<Vec3> clipped_polygon(Corners polygon, const Vec3& normal, double offset);

/// The integral of the direction towards a polygon over the solid angle that it takes, seen from its front
/// [sr]: the sum over its edges of angle times normal, half of it (Lambert 1760; Arvo 1994, eq. 4). Negative
/// seen from behind. The net flux at the point is that times the polygon's radiance, and opposite.
Vec3 lambert_vector(const Vec3& point, Corners polygon);

/// Solid angle of a triangle, positive seen from its front [sr] (van Oosterom and Strackee 1983, eq. 8).
double solid_angle(const Vec3& point, const TriangleCorners& triangle);

/// Form factor of a small element at a point with a unit normal to a convex polygon, of which it sees the
/// front above its horizon.
double point_factor(const Vec3& point, const Vec3& normal, Corners polygon);

}  // namespace etendue
