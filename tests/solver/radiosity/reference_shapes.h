// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/radiosity/form_factors/flat_patch.h"
#include "solver/radiosity/form_factors/lambert.h"

namespace etendue {

/// A row of validation/reference/form_factors.csv as surfaces. Discs, spheres and cylinders are of facets
/// with the same area, infinite ones are long.
struct ReferenceShape {
  std::string name;
  double factor = 0;
  std::vector<TriangleCorners> from;
  std::vector<TriangleCorners> scene;
  std::vector<std::size_t> group_of;  ///< [triangle of the scene]; 0: what the factor is to
  bool is_element = false;            ///< `from` is so small that it is a point
  bool is_flat = false;               ///< nothing is curved or hidden
};

/// All rows.
std::vector<ReferenceShape> reference_shapes();

/// The triangles of a convex polygon.
std::vector<TriangleCorners> polygon_triangles(Corners corners);
/// A sphere about the origin with the same area, seen from outside.
std::vector<TriangleCorners> sphere_triangles(double radius, int divisions);
/// The same surfaces seen from the other side.
std::vector<TriangleCorners> turned(std::vector<TriangleCorners> triangles);
/// The inside of a sphere of radius 1, a patch for each triangle.
std::vector<FlatPatch> sphere_patches(int divisions);

}  // namespace etendue
