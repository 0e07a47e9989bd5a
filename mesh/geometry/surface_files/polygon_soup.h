// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// Polygons as a file lists them: nothing is known yet of how they hang together.
struct PolygonSoup {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> polygons;  ///< indices of points
  std::vector<int> walls;                  ///< [polygon] index into wall_names
  std::vector<std::string> wall_names;
};

/// ASCII STL; walls are its solids.
PolygonSoup read_ascii_stl(const std::filesystem::path& path);
/// Wavefront OBJ; walls are its groups (g), or its materials (usemtl) where there are no groups, or its
/// objects (o) where there are neither.
PolygonSoup read_obj(const std::filesystem::path& path);
/// Binary STL, PLY and OFF by CGAL; one wall "boundary".
PolygonSoup read_by_cgal(const std::filesystem::path& path);

/// A closed surface of triangles, each edge of which has two.
struct ClosedSurface {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> walls;  ///< [triangle]
};

/// The same with a border, which every edge of one triangle is part of.
using OpenSurface = ClosedSurface;

/// Joins equal points, orients and triangulates. Throws std::invalid_argument with coordinates where the
/// surface has holes, edges of more than two polygons, triangles without area, or cuts itself.
ClosedSurface close_surface(const PolygonSoup& soup);
/// The same of polygons that close nothing: their border stays.
OpenSurface open_surface(const PolygonSoup& soup);

}  // namespace etendue
