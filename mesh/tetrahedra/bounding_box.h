// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "base/vec3.h"

namespace etendue {

/// The smallest box along the axes.
struct BoundingBox {
  Vec3 low, high;
  double diagonal() const { return (high - low).norm(); }
};

/// That of some points, of which there must be one.
BoundingBox bounding_box(std::span<const Vec3> points);

}  // namespace etendue
