// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>

#include "base/vec3.h"

namespace etendue {

/// Distance of a point from the segment between two others.
inline double distance_to_segment(const Vec3& x, const Vec3& p, const Vec3& q) {
  const Vec3 along = q - p;
  const double t = std::clamp((x - p).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (x - p - t * along).norm();
}

}  // namespace etendue
