// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/geometry/primitives/enclosed_parts.h"
#include "mesh/geometry/primitives/surface_complex.h"

namespace etendue {

/// Normal of a flat outline, as long as twice its area (Newell's sum over the edges).
Vec3 outline_area_normal(const std::vector<Vec3>& points, const std::vector<int>& outline);

/// Gives a facet of outlines its two sides. The first outline is the outer one; others are the rims of
/// openings where an opening point lies in them, else lines inside the facet.
SidedFacet sided_facet(const std::vector<Vec3>& points, const SurfaceFacet& facet);

/// The same for a triangle.
SidedFacet sided_facet(const std::vector<Vec3>& points, const std::array<int, 3>& triangle);

}  // namespace etendue
