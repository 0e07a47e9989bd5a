// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/geometry/geometry.h"
#include "mesh/geometry/surface_complex.h"

namespace etendue {

/// The surfaces of a scene that has only boxes, with exactly the coordinates of the scene.
SurfaceComplex arrange_boxes(const Geometry& geometry);

}  // namespace etendue
