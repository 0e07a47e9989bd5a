// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/log.h"
#include "mesh/geometry/primitives/geometry.h"

namespace etendue {

/// Distance [length] within which coordinates of a scene count as equal: its part of the scene's longest
/// side.
double snap_distance(const Geometry& geometry);

/// The scene with coordinates along an axis, and radii, that lie within the snap distance of each other made
/// equal to the first of them in the file. The log is told where that moves something. Throws InputError for
/// a body that is thinner.
Geometry snapped(Geometry geometry, const Log& log = {});

}  // namespace etendue
