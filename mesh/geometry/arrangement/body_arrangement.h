// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/geometry/primitives/geometry.h"
#include "mesh/geometry/primitives/surface_complex.h"

namespace etendue {

/// The surfaces of a scene of boxes, spheres and cylinders that may cross each other in any way. All bodies
/// are convex polyhedra; facets are found plane by plane with exact coordinates and rounded at the end.
SurfaceComplex arrange_bodies(const Geometry& geometry);

}  // namespace etendue
