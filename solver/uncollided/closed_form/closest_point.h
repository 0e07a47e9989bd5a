// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>

#include "base/vec3.h"

namespace etendue {

/// The point of a triangle that is nearest to a point of space.
Vec3 closest_in_triangle(const Vec3& point, const std::array<Vec3, 3>& triangle);

/// The point of a tetrahedron that is nearest: the point itself where it lies inside.
Vec3 closest_in_tetrahedron(const Vec3& point, const std::array<Vec3, 4>& corners);

}  // namespace etendue
