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
/// The same before they are joined, which takes the square of their number.
std::vector<Side> single_sides(std::span<const std::array<Vec3, 3>> triangles);

/// The corners in order of a flat and convex piece that such triangles about a normal make up; empty where
/// the piece is neither, or they make up several.
std::vector<Vec3> convex_outline(std::span<const std::array<Vec3, 3>> triangles, const Vec3& normal);

/// From a point to the nearest one of a side [length].
double distance_to_side(const Vec3& point, const Vec3& first, const Vec3& second);

}  // namespace etendue
