// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// A flat piece of surface: closed outlines, single segments and lone points in one plane, with a point in
/// each opening.
struct SurfaceFacet {
  std::vector<std::vector<int>> polygons;  ///< indices of points; two make a segment, one a lone point
  std::vector<Vec3> openings;              ///< a point in each hole of the facet
  int wall = -1;   ///< index into wall_names; -1: an interface between two regions, or a sheet
  int sheet = -1;  ///< index into sheets; -1: none
};

/// What stands on the two sides of facets inside the domain that light does not pass.
struct SurfaceSheet {
  int front = 0;  ///< index into wall_names: the side that the normal points to
  int back = 0;
  Vec3 normal = Vec3::UnitZ();  ///< unit
};

/// A point inside a region, for the mesher to flood the region from.
struct RegionSeed {
  Vec3 point = Vec3::Zero();
  int region = 0;  ///< index into region_names
};

/// The surfaces that bound and divide the domain: a piecewise linear complex.
struct SurfaceComplex {
  std::vector<Vec3> points;
  std::vector<SurfaceFacet> facets;
  std::vector<RegionSeed> seeds;  ///< one in each connected part
  std::vector<Vec3> holes;        ///< one point in each connected part that is not meshed
  std::vector<std::string> region_names;
  std::vector<std::string> wall_names;
  std::vector<SurfaceSheet> sheets = {};
};

}  // namespace etendue
