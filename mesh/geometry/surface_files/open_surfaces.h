// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/geometry/surface_files/polygon_soup.h"

namespace etendue {

/// The polygons of a file by what they hang together with.
struct SoupParts {
  PolygonSoup closed;  ///< pieces without a border
  PolygonSoup open;    ///< pieces with one
};

/// Pieces hang together by edges that two polygons share; an edge of one polygon is a border. Where all
/// pieces are open, or some edge has more polygons, all count as closed, and close_surface refuses them.
SoupParts parts_of(const PolygonSoup& soup);

}  // namespace etendue
