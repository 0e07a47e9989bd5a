// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/problem/problem.h"

namespace etendue {

enum class Obstacle { box, sheet };

/// The part of space that the obstacle fills; a sheet lies in its lower side.
inline const Vec3 obstacle_low(0.35, 0.3, 0.45), obstacle_high(0.65, 0.7, 0.5);

std::vector<Vec3> corners_of(Obstacle obstacle);

/// A unit cube with the obstacle in its middle.
TetrahedralMesh room_with(Obstacle obstacle, double max_volume);

constexpr double lamp_height = 0.9;
/// Rims of lights in the upper part of the room, at that height, clockwise as seen from above: they shine
/// down.
std::vector<Vec3> rectangle(double x, double y);
std::vector<Vec3> disc(double radius, int sides = 64);

/// A light with this rim, of radiance 1.
Light flat_light(const std::vector<Vec3>& rim);

}  // namespace etendue
