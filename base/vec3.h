// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace etendue {

/// A point, a displacement or a direction in space.
using Vec3 = Eigen::Vector3d;

}  // namespace etendue
