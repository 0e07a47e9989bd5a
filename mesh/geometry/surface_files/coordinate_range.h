// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vec3.h"

namespace etendue {

/// Throws std::invalid_argument where the volumes, squared, of a surface with these points would overflow or
/// be lost, with the point that is too far out.
void check_range(const std::vector<Vec3>& points);

}  // namespace etendue
