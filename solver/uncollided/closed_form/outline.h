// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// From one end to the other.
using Side = std::pair<Vec3, Vec3>;

/// The sides of a flat piece that triangles in one plane make up, in their sense of rotation: those that
/// only one of the triangles has, joined where they continue in one line. Triangles that share a side have it
/// turned round, with the same corners.
std::vector<Side> outline(std::span<const std::array<Vec3, 3>> triangles);

/// From a point to the nearest one of a side [length].
double distance_to_side(const Vec3& point, const Vec3& first, const Vec3& second);

}  // namespace etendue
