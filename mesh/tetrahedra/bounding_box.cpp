// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/bounding_box.h"

namespace etendue {

BoundingBox bounding_box(std::span<const Vec3> points) {
  BoundingBox box{points.front(), points.front()};
  for (const Vec3& point : points) {
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
  }
  return box;
}

}  // namespace etendue
