// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vec3.h"

namespace etendue {

using Triangle = std::array<Vec3, 3>;

/// Unit normals that agree to this, and offsets to this part of the size, are those of one plane; so are the
/// corners of walls that a file gives.
inline constexpr double one_plane = 1e-6;
/// Heights above a plane, in units of the size, that are rounding: rays end at walls to 1e-9 of their length.
inline constexpr double rounding_height = 1e-10;

/// Area times normal.
inline Vec3 area_vector(const Triangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]) / 2; }

inline double longest_side(const Triangle& t) {
  return std::sqrt(
      std::max({(t[0] - t[1]).squaredNorm(), (t[1] - t[2]).squaredNorm(), (t[2] - t[0]).squaredNorm()}));
}

}  // namespace etendue
