// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/geometry/surface_files/polygon_soup.h"

namespace etendue {

/// Cuts polygons that come back to a corner into triangles between their corners, and leaves the others. CAD
/// programs write a polygon with holes like this, as one outline with a bridge to each hole (a keyhole). What
/// an odd number of outlines surrounds belongs to the polygon; bridges go. Equal points must have one number.
/// Throws std::invalid_argument with coordinates where the outline of such a polygon crosses itself.
PolygonSoup with_simple_polygons(const PolygonSoup& soup);

}  // namespace etendue
