// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>

#include "base/vec3.h"

namespace etendue {

/// Area that a triangle and a disc in its plane have in common [length^2].
double area_in_disc(const std::array<Vec3, 3>& corners, const Vec3& center, double radius);

}  // namespace etendue
