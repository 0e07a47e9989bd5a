// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// The directions of one half of the sphere (z > 0; where z = 0, y > 0; …), octant by octant and within each
/// along a Sierpinski curve: neighbours in the list are close in angle, and so are their opposites.
std::vector<std::int32_t> upper_directions_along_curve(std::span<const Vec3> directions);

}  // namespace etendue
