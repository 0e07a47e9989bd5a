// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vec3.h"

namespace etendue {

/// The point of a surface, scaled. Throws std::invalid_argument where it is so far out that squares of areas,
/// or volumes, overflow.
const Vec3& checked_range(const Vec3& point);

/// Throws std::invalid_argument where all points are so near to the origin that these vanish.
void check_extent(const std::vector<Vec3>& points);

}  // namespace etendue
