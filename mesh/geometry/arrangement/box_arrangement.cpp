// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/arrangement/box_arrangement.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/position.h"
#include "mesh/geometry/arrangement/box_facets.h"
#include "mesh/geometry/arrangement/elementary_boxes.h"
#include "mesh/geometry/primitives/wall_naming.h"

namespace etendue {
namespace {

/// Writes facets as segments between corners: every line where facets end, once for each facet it bounds.
class SegmentWriter {
 public:
  SegmentWriter(const ElementaryBoxes& grid, const BoxFacets& facets, SurfaceComplex& surface)
      : grid_(grid), facets_(facets), surface_(surface) {
    for (int axis = 0; axis < 3; ++axis) write_lines(axis);
  }

 private:
  void write_lines(int axis) {
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    GridIndex node{};
    for (node[position(b)] = 0; node[position(b)] <= grid_.count(b); ++node[position(b)])
      for (node[position(c)] = 0; node[position(c)] <= grid_.count(c); ++node[position(c)])
        write_line(axis, node);
  }

  void write_line(int axis, GridIndex node) {
    int start = -1;
    for (node[position(axis)] = 0; node[position(axis)] <= grid_.count(axis); ++node[position(axis)]) {
      if (!facets_.is_corner(node)) continue;
      const int end = point(node);
      const GridIndex edge = moved(node, axis, -1);
      if (facets_.is_edge(axis, edge)) write_segment(axis, edge, start, end);
      start = end;
    }
  }

  void write_segment(int axis, const GridIndex& edge, int start, int end) {
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    const std::set<int> bounded{facets_.facet(b, edge), facets_.facet(b, moved(edge, c, -1)),
                                facets_.facet(c, edge), facets_.facet(c, moved(edge, b, -1))};
    for (const int facet : bounded)
      if (facet >= 0) surface_.facets[position(facet)].polygons.push_back({start, end});
  }

  int point(const GridIndex& node) {
    const auto [entry, added] = numbers_.try_emplace(node, static_cast<int>(surface_.points.size()));
    if (added) surface_.points.push_back(grid_.corner(node));
    return entry->second;
  }

  const ElementaryBoxes& grid_;
  const BoxFacets& facets_;
  SurfaceComplex& surface_;
  std::map<GridIndex, int> numbers_;
};

/// A point in each opening of a facet: in each part of its plane that the facet shuts in.
std::vector<Vec3> openings(const BoxFacet& facet, int number, const BoxFacets& facets,
                           const ElementaryBoxes& grid) {
  const int b = (facet.axis + 1) % 3, c = (facet.axis + 2) % 3;
  GridIndex low = facet.rectangles.front(), high = low;
  for (const GridIndex& r : facet.rectangles) {
    for (const int axis : {b, c}) {
      low[position(axis)] = std::min(low[position(axis)], r[position(axis)]);
      high[position(axis)] = std::max(high[position(axis)], r[position(axis)]);
    }
  }
  std::set<GridIndex> visited;
  // Floods what is not facet; true where the flood leaves the facet's bounding rectangle.
  const auto leaves = [&](const GridIndex& start) {
    bool left = false;
    std::vector<GridIndex> front{start};
    visited.insert(start);
    while (!front.empty()) {
      const GridIndex r = front.back();
      front.pop_back();
      for (const int axis : {b, c}) {
        for (const int step : {-1, 1}) {
          const GridIndex next = moved(r, axis, step);
          if (next[position(axis)] < low[position(axis)] || next[position(axis)] > high[position(axis)])
            left = true;
          else if (facets.facet(facet.axis, next) != number && visited.insert(next).second)
            front.push_back(next);
        }
      }
    }
    return left;
  };
  std::vector<Vec3> points;
  GridIndex r = low;
  for (r[position(b)] = low[position(b)]; r[position(b)] <= high[position(b)]; ++r[position(b)]) {
    for (r[position(c)] = low[position(c)]; r[position(c)] <= high[position(c)]; ++r[position(c)]) {
      if (facets.facet(facet.axis, r) == number || visited.contains(r) || leaves(r)) continue;
      const GridIndex across = moved(moved(r, b, 1), c, 1);
      points.push_back(0.5 * (grid.corner(r) + grid.corner(across)));
    }
  }
  return points;
}

/// A seed in each connected part of each region and a hole point in each part of the void that is shut in.
class PartFinder {
 public:
  PartFinder(const ElementaryBoxes& grid, SurfaceComplex& surface)
      : grid_(grid), visited_(grid.size(), false) {
    for (int i = 0; i < grid.count(0); ++i)
      for (int j = 0; j < grid.count(1); ++j)
        for (int k = 0; k < grid.count(2); ++k)
          if (!visited_[grid.at({i, j, k})]) flood({i, j, k}, surface);
  }

 private:
  void flood(const GridIndex& start, SurfaceComplex& surface) {
    const SpaceLabel label = std::max(grid_.label(start), kOutside);
    GridIndex thickest = start;  // its middle is the safest seed
    bool open = false;
    std::vector<GridIndex> front{start};
    visited_[grid_.at(start)] = true;
    while (!front.empty()) {
      const GridIndex box = front.back();
      front.pop_back();
      if (grid_.thickness(box) > grid_.thickness(thickest)) thickest = box;
      for (int axis = 0; axis < 3; ++axis) {
        for (const int step : {-1, 1}) {
          const GridIndex next = moved(box, axis, step);
          if (!grid_.contains(next)) {
            open = true;
          } else if (!visited_[grid_.at(next)] && std::max(grid_.label(next), kOutside) == label) {
            visited_[grid_.at(next)] = true;
            front.push_back(next);
          }
        }
      }
    }
    if (!is_void(label))
      surface.seeds.push_back({grid_.middle(thickest), label});
    else if (!open)
      surface.holes.push_back(grid_.middle(thickest));
  }

  const ElementaryBoxes& grid_;
  std::vector<bool> visited_;
};

}  // namespace

SurfaceComplex arrange_boxes(const Geometry& geometry) {
  std::vector<std::string> region_names;
  const std::vector<SpaceLabel> labels = primitive_labels(geometry, region_names);
  SurfaceComplex surface = arrange_grid(geometry, ElementaryBoxes(geometry, labels));
  surface.region_names = std::move(region_names);
  return surface;
}

SurfaceComplex arrange_grid(const Geometry& geometry, const ElementaryBoxes& grid, FacetSize size) {
  SurfaceComplex surface;
  const BoxFacets facets(geometry, grid, size);
  if (!facets.faults().empty()) throw InputError(facets.faults());
  surface.wall_names = facets.wall_names();
  for (std::size_t i = 0; i < facets.facets().size(); ++i) {
    const BoxFacet& facet = facets.facets()[i];
    surface.facets.push_back({{}, openings(facet, static_cast<int>(i), facets, grid), facet.wall});
  }
  SegmentWriter(grid, facets, surface);
  PartFinder(grid, surface);
  return surface;
}

}  // namespace etendue
