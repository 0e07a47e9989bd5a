// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/vec3.h"

namespace etendue {

/// The axis that points up in a file.
enum class UpAxis { y, z };

/// A point of such a file where z points up: files with y up are turned about x by 90 degrees.
inline Vec3 with_z_up(const Vec3& point, UpAxis up) {
  return up == UpAxis::z ? point : Vec3(point.x(), -point.z(), point.y());
}

}  // namespace etendue
