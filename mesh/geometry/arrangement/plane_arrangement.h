// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "mesh/geometry/arrangement/convex_body.h"
#include "mesh/geometry/arrangement/sheet_triangles.h"
#include "mesh/geometry/primitives/wall_naming.h"

namespace etendue {

/// What the facets of every plane are found from.
struct BodyScene {
  const Geometry& geometry;
  std::vector<SpaceLabel> labels;     ///< [primitive]
  std::vector<ConvexBody> bodies;     ///< [primitive]
  std::vector<NamedRectangle> named;  ///< those that count more later
  std::vector<SheetTriangle> sheets;  ///< those that count more later
};

/// A face of a body.
struct BodyFace {
  int body;
  int face;
};

/// A plane with the faces that lie in it. Its normal's largest component is positive.
struct FacePlane {
  ExactPlane plane;
  Vec3 normal;  ///< unit, rounded
  int axis;     ///< of the normal's largest component
  std::vector<BodyFace> faces;
};

/// The distinct planes of all faces.
std::vector<FacePlane> face_planes(const BodyScene& scene);

/// A facet of the arrangement with exact corners.
struct ExactFacet {
  ExactPlane plane;
  Vec3 normal;                                   ///< unit, rounded
  std::vector<std::array<ExactPoint, 2>> edges;  ///< the facet is on their left, seen from the normal's tip
  std::vector<ExactPoint> openings;
  ExactPoint inside;
  SpaceLabel below, above;  ///< region or kOutside on the two sides; above is where the normal points
  int wall;                 ///< -1: an interface, or a sheet
  int sheet;                ///< index into the geometry's; -1: none
};

/// The facets in one plane: where the labels on its two sides differ. Corners stand only where the facets
/// of this plane turn or change. `used_patches` gathers the patches that name a facet.
std::vector<ExactFacet> facets_in_plane(const FacePlane& plane, const BodyScene& scene, WallNames& walls,
                                        std::set<int>& used_patches);

}  // namespace etendue
