// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "solver/problem/lights/light.h"

namespace etendue {

/// The distance [length] at which a ray along a unit direction passes the triangles of a flat light, three
/// corners each, that are seen counterclockwise from the ray's start; empty where it passes none.
std::optional<double> distance_to_front(std::span<const Vec3> corners, const Vec3& from,
                                        const Vec3& direction);

/// Flat light that a ray crosses, and the distance to it; such lights transmit rays.
struct TransmittedLight {
  const SurfaceLight* light;
  double distance;  ///< [length]
};
/// Returns the flat lights that a ray along a unit direction crosses within `length`.
std::vector<TransmittedLight> transmitted_lights(std::span<const Light> lights, const Vec3& from,
                                                 const Vec3& direction, double length);

}  // namespace etendue
