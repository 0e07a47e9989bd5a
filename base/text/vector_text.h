// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "base/vec3.h"

namespace etendue {

/// A point or a direction as messages show it: (x, y, z) with six digits each.
std::string vector_text(const Vec3& vector);

}  // namespace etendue
