// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// The corners of the convex polygons into which a flat piece falls that triangles about a normal make up;
/// triangles that share a side have the same corners there. Empty where they are many, or would not cover
/// what the triangles do.
std::vector<std::vector<Vec3>> convex_parts(std::span<const std::array<Vec3, 3>> triangles,
                                            const Vec3& normal);

}  // namespace etendue
