// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/geometry/arrangement/elementary_boxes.h"
#include "mesh/geometry/primitives/geometry.h"
#include "mesh/geometry/primitives/surface_complex.h"

namespace etendue {

/// The surfaces of a scene that has only boxes, with exactly the coordinates of the scene.
SurfaceComplex arrange_boxes(const Geometry& geometry);

/// The surfaces of boxes that are labeled already, without names of regions. The geometry names walls: holes
/// by their labels, sides by boxes and patches.
SurfaceComplex arrange_grid(const Geometry& geometry, const ElementaryBoxes& grid,
                            FacetSize size = FacetSize::largest);

}  // namespace etendue
