// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/geometry/primitives/exact.h"
#include "mesh/geometry/primitives/geometry.h"

namespace etendue {

/// A convex polyhedron with exactly flat faces.
struct ConvexBody {
  std::vector<ExactPoint> points;
  std::vector<std::vector<int>> faces;  ///< indices of points, counter-clockwise seen from outside
  std::vector<ExactPlane> planes;       ///< [face] normal outward
  std::vector<ExactPoint> middles;      ///< of many-sided oblique faces: extra corners for their triangles
  Vec3 low, high;                       ///< a box around it
};

/// Sides of boxes, which vertices of round bodies snap to.
struct SnapPlanes {
  std::array<std::vector<double>, 3> sides;  ///< [axis]
  double distance = 0;                       ///< [length] within which they snap
};
SnapPlanes snap_planes(const Geometry& geometry);

/// A primitive as a polyhedron. A sphere becomes the icosahedron with each edge split into equal parts and
/// its vertices moved onto the sphere; a cylinder a regular prism with its edges on the cylinder. Vertices of
/// spheres, and of cylinders along an axis, snap to planes.
ConvexBody convex_body(const Primitive& primitive, const SnapPlanes& snap);

/// Parts per edge of the icosahedron for which the number of triangles, 20 n^2, is nearest to `facets`.
int icosahedron_parts(int facets);

/// Whether a point lies inside or on the body.
bool contains(const ConvexBody& body, const ExactPoint& point);

}  // namespace etendue
