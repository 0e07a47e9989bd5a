// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "mesh/geometry/primitives/surface_complex.h"

namespace etendue {

/// The area that a facet's outlines and segments enclose [length^2], openings not counted.
double facet_area(const SurfaceComplex& surface, const SurfaceFacet& facet);

/// Summed over the facets of each wall; interfaces under "".
std::map<std::string, double> wall_areas(const SurfaceComplex& surface);

/// Number of seeds of each region.
std::map<std::string, int> seed_counts(const SurfaceComplex& surface);

}  // namespace etendue
