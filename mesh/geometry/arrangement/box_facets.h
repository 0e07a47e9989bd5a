// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/geometry/arrangement/elementary_boxes.h"

namespace etendue {

/// Coplanar elementary rectangles that hang together and part the same regions under the same name.
struct BoxFacet {
  int axis = 0;   ///< of the normal
  int plane = 0;  ///< its plane's number along the axis
  int wall = -1;  ///< index into wall names; -1: an interface
  std::vector<GridIndex> rectangles;
};

/// The elementary rectangles of a grid gathered into facets. A rectangle is numbered by the plane along its
/// normal and by the boxes along the other axes; an edge by the box along it and planes otherwise.
class BoxFacets {
 public:
  BoxFacets(const Geometry& geometry, const ElementaryBoxes& grid, FacetSize size = FacetSize::largest);

  const std::vector<BoxFacet>& facets() const { return facets_; }
  const std::vector<std::string>& wall_names() const { return wall_names_.all(); }
  /// The facet that a rectangle belongs to; -1: none, also beyond the grid.
  int facet(int axis, const GridIndex& rectangle) const;
  /// Whether facets end or change at an elementary edge.
  bool is_edge(int axis, const GridIndex& edge) const;
  /// Whether edges end, turn or meet at a node.
  bool is_corner(const GridIndex& node) const;
  /// Faults of the patches that name nothing.
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  using Key = std::array<int, 3>;  ///< lower region, upper region, wall

  std::size_t at(int axis, const GridIndex& rectangle) const;
  Key& key(int axis, const GridIndex& rectangle);
  void find_facets(const Geometry& geometry, int axis);
  void find_keys(const Geometry& geometry, const std::vector<NamedRectangle>& named, int axis, int plane);
  int find_wall(const Geometry& geometry, const std::vector<NamedRectangle>& named, int axis,
                const GridIndex& rectangle);
  void gather(int axis, int plane);
  void grow(int axis, const GridIndex& start);

  const ElementaryBoxes& grid_;
  FacetSize size_;
  std::vector<Key> keys_;                   ///< [rectangle] of the plane at hand
  std::array<std::vector<int>, 3> sheets_;  ///< [axis of the normal][rectangle] facet
  std::vector<BoxFacet> facets_;
  WallNames wall_names_;
  std::vector<bool> patch_used_;
  std::vector<Fault> faults_;
};

}  // namespace etendue
