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

/// A flat light that a ray passes.
struct PassedLight {
  const SurfaceLight* light;
  double distance;  ///< [length]
};
/// Those among the lights that a ray along a unit direction passes on this length.
std::vector<PassedLight> lights_passed(std::span<const Light> lights, const Vec3& from, const Vec3& direction,
                                       double length);

}  // namespace etendue
