// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/vec3.h"

namespace etendue {

/// A face with |w.n| below this is parallel to the direction, on both sides.
inline constexpr double parallel_cosine = 1e-14;

/// Projected area of a face, w . (A n) [length^2]; exactly zero where face and direction are parallel.
inline double projected_area(const Vec3& area_normal, const Vec3& direction) {
  const double a = direction.dot(area_normal);
  // Squares instead of a root: this is asked of all faces for every direction.
  return a * a < parallel_cosine * parallel_cosine * area_normal.squaredNorm() ? 0 : a;
}

}  // namespace etendue
