// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/geometry/primitives/geometry.h"

namespace etendue {

/// Unit; to where the corners are seen counterclockwise.
Vec3 sheet_normal(const Sheet& sheet);

/// What is wrong with the corners; empty: nothing.
std::string sheet_fault(const Sheet& sheet);

/// An axis-aligned rectangle as a polygon whose front looks along the axis.
std::vector<Vec3> rectangle_corners(const Vec3& min, const Vec3& max);

Fault sheet_is_nowhere(const Sheet& sheet);

}  // namespace etendue
