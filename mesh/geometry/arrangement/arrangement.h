// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/log.h"
#include "mesh/geometry/primitives/geometry.h"
#include "mesh/geometry/primitives/surface_complex.h"

namespace etendue {

/// The surfaces of a scene of primitives. Later primitives overwrite earlier ones; facets stand where two
/// regions meet and where a region meets the outside. A boundary facet is named by the last patch that
/// covers it, else by the last box in the file that names that side explicitly, else by its outward axis
/// (xmin … zmax); the surface of a hole by `name.xmin` … `name.zmax`, of a round hole by `name`. Coordinates
/// within the snap distance of each other are made equal first.
/// Throws InputError with the origin of the primitive that cannot be used.
SurfaceComplex arrange(const Geometry& scene, const Log& log = {});

}  // namespace etendue
