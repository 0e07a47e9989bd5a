// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "mesh/base/vec3.h"

namespace etendue {

/// The distance [length] at which a ray along a unit direction passes the triangles of a flat light, three
/// corners each, that are seen counterclockwise from the ray's start; empty where it passes none.
std::optional<double> distance_to_front(std::span<const Vec3> corners, const Vec3& from,
                                        const Vec3& direction);

}  // namespace etendue
