// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "base/angular_space.h"
#include "base/vec3.h"

namespace etendue {

/// An orthogonal matrix of determinant 1.
using Rotation = Eigen::Matrix3d;

/// About an axis of any length but zero, counterclockwise as seen from its tip.
Rotation rotation_about(const Vec3& axis, double degrees);

/// Every rotation with the same probability; the same one for a seed on every machine.
/// In the plane rotations about z are drawn.
Rotation random_rotation(std::uint64_t seed, AngularSpace space = AngularSpace::sphere);

}  // namespace etendue
