// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/geometry/primitives/geometry.h"

namespace etendue {

/// Labels what fills a point of space: regions count from 0, the outside is -1, holes count from -2 down.
using SpaceLabel = int;
inline constexpr SpaceLabel kOutside = -1;
constexpr SpaceLabel hole_label(int primitive) { return -2 - primitive; }
constexpr bool is_void(SpaceLabel label) { return label < 0; }

/// An axis-aligned rectangle that gives its name to the boundary facets it covers.
struct NamedRectangle {
  int axis = 0;     ///< that its normal is along
  int outward = 0;  ///< +1 or -1: only facets whose outward normal points so; 0: both
  Vec3 min = Vec3::Zero();
  Vec3 max = Vec3::Zero();
  std::string wall;
  int primitive = -1;  ///< that names its side
  int patch = -1;      ///< that names it

  double plane() const { return min[axis]; }
};

/// All of them, those that count more later: sides named by boxes in the order of the file, then patches.
std::vector<NamedRectangle> named_rectangles(const Geometry& geometry);

/// The label of each primitive; `region_names` gets the names in order of first use.
std::vector<SpaceLabel> primitive_labels(const Geometry& geometry, std::vector<std::string>& region_names);

/// Names of walls, each numbered when it is first met.
class WallNames {
 public:
  int number(const std::string& name);
  const std::vector<std::string>& all() const { return names_; }

 private:
  std::vector<std::string> names_;
};

/// "xmin" … "zmax".
std::string side_name(int axis, int outward);

/// Whether a rectangle may name a facet that has the void `beyond` behind it: patches always, box sides
/// unless a later hole made the facet.
bool may_name(const NamedRectangle& rectangle, SpaceLabel beyond);

/// The name of a facet that no rectangle names: of the hole behind it, else of its outward axis.
std::string default_name(const Geometry& geometry, SpaceLabel beyond, int axis, int outward);

}  // namespace etendue
