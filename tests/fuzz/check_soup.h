// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdlib>

#include "mesh/geometry/surface_files/open_surfaces.h"

namespace etendue::test {

/// Ends the program where a polygon has a point or a wall that does not exist.
inline void check(const PolygonSoup& soup) {
  if (soup.walls.size() != soup.polygons.size()) std::abort();
  for (const Vec3& point : soup.points)
    if (!point.allFinite()) std::abort();
  for (const std::vector<int>& polygon : soup.polygons)
    for (const int point : polygon)
      if (point < 0 || static_cast<std::size_t>(point) >= soup.points.size()) std::abort();
  for (const int wall : soup.walls)
    if (wall < 0 || static_cast<std::size_t>(wall) >= soup.wall_names.size()) std::abort();
  const SoupParts parts = parts_of(soup);
  if (parts.closed.polygons.size() + parts.open.polygons.size() != soup.polygons.size()) std::abort();
}

}  // namespace etendue::test
