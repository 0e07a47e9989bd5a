// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/arrangement/box_facets.h"

#include <algorithm>

#include "base/position.h"
#include "mesh/geometry/primitives/primitive_checks.h"

namespace etendue {
namespace {

constexpr std::array<int, 3> kNoFacet{-1, -1, -1};

/// Whether a named rectangle covers an elementary one whose corners are `low` and `high`.
bool covers(const NamedRectangle& named, const Vec3& low, const Vec3& high) {
  for (int axis = 0; axis < 3; ++axis)
    if (named.min[axis] > low[axis] || named.max[axis] < high[axis]) return false;
  return true;
}

}  // namespace

BoxFacets::BoxFacets(const Geometry& geometry, const ElementaryBoxes& grid, FacetSize size)
    : grid_(grid), size_(size), patch_used_(geometry.patches.size(), false) {
  for (int axis = 0; axis < 3; ++axis) find_facets(geometry, axis);
  for (std::size_t i = 0; i < patch_used_.size(); ++i)
    if (!patch_used_[i]) faults_.push_back(patch_covers_nothing(geometry.patches[i]));
}

std::size_t BoxFacets::at(int axis, const GridIndex& rectangle) const {
  const auto b = position((axis + 1) % 3), c = position((axis + 2) % 3);
  return (position(rectangle[position(axis)]) * position(grid_.count(static_cast<int>(b))) +
          position(rectangle[b])) *
             position(grid_.count(static_cast<int>(c))) +
         position(rectangle[c]);
}

BoxFacets::Key& BoxFacets::key(int axis, const GridIndex& rectangle) {
  GridIndex in_plane = rectangle;
  in_plane[position(axis)] = 0;
  return keys_[at(axis, in_plane)];
}

int BoxFacets::facet(int axis, const GridIndex& rectangle) const {
  const GridIndex below = moved(rectangle, axis, -1);
  if (!grid_.contains(rectangle) && !grid_.contains(below)) return -1;
  return sheets_[position(axis)][at(axis, rectangle)];
}

bool BoxFacets::is_edge(int axis, const GridIndex& edge) const {
  const int b = (axis + 1) % 3, c = (axis + 2) % 3;
  return facet(b, edge) != facet(b, moved(edge, c, -1)) || facet(c, edge) != facet(c, moved(edge, b, -1));
}

bool BoxFacets::is_corner(const GridIndex& node) const {
  int straight = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const bool before = is_edge(axis, moved(node, axis, -1));
    const bool after = is_edge(axis, node);
    if (before != after) return true;
    if (after) ++straight;
  }
  return straight > 1;
}

void BoxFacets::find_facets(const Geometry& geometry, int axis) {
  const int b = (axis + 1) % 3, c = (axis + 2) % 3;
  sheets_[position(axis)].assign(
      position(grid_.count(axis) + 1) * position(grid_.count(b)) * position(grid_.count(c)), -1);
  const std::vector<NamedRectangle> all = named_rectangles(geometry);
  for (int plane = 0; plane <= grid_.count(axis); ++plane) {
    std::vector<NamedRectangle> named;
    std::copy_if(all.begin(), all.end(), std::back_inserter(named), [&](const NamedRectangle& rectangle) {
      return rectangle.axis == axis && rectangle.plane() == grid_.plane(axis, plane);
    });
    find_keys(geometry, named, axis, plane);
    gather(axis, plane);
  }
}

void BoxFacets::find_keys(const Geometry& geometry, const std::vector<NamedRectangle>& named, int axis,
                          int plane) {
  const int b = (axis + 1) % 3, c = (axis + 2) % 3;
  keys_.assign(position(grid_.count(b)) * position(grid_.count(c)), kNoFacet);
  GridIndex r{};
  r[position(axis)] = plane;
  for (r[position(b)] = 0; r[position(b)] < grid_.count(b); ++r[position(b)]) {
    for (r[position(c)] = 0; r[position(c)] < grid_.count(c); ++r[position(c)]) {
      const SpaceLabel lower = std::max(grid_.label(moved(r, axis, -1)), kOutside);
      const SpaceLabel upper = std::max(grid_.label(r), kOutside);
      if (lower == upper) continue;
      const bool wall = is_void(lower) || is_void(upper);
      key(axis, r) = {lower, upper, wall ? find_wall(geometry, named, axis, r) : -1};
    }
  }
}

int BoxFacets::find_wall(const Geometry& geometry, const std::vector<NamedRectangle>& named, int axis,
                         const GridIndex& rectangle) {
  const SpaceLabel lower = grid_.label(moved(rectangle, axis, -1)), upper = grid_.label(rectangle);
  const int outward = is_void(upper) ? 1 : -1;
  const SpaceLabel beyond = is_void(upper) ? upper : lower;
  const Vec3 low = grid_.corner(rectangle);
  const Vec3 high = grid_.corner(moved(moved(rectangle, (axis + 1) % 3, 1), (axis + 2) % 3, 1));
  for (auto candidate = named.rbegin(); candidate != named.rend(); ++candidate) {
    if (candidate->outward == -outward || !may_name(*candidate, beyond) || !covers(*candidate, low, high))
      continue;
    if (candidate->patch >= 0) patch_used_[position(candidate->patch)] = true;
    return wall_names_.number(candidate->wall);
  }
  return wall_names_.number(default_name(geometry, beyond, axis, outward));
}

void BoxFacets::gather(int axis, int plane) {
  const int b = (axis + 1) % 3, c = (axis + 2) % 3;
  GridIndex r{};
  r[position(axis)] = plane;
  for (r[position(b)] = 0; r[position(b)] < grid_.count(b); ++r[position(b)])
    for (r[position(c)] = 0; r[position(c)] < grid_.count(c); ++r[position(c)])
      if (key(axis, r) != kNoFacet && sheets_[position(axis)][at(axis, r)] < 0) grow(axis, r);
}

void BoxFacets::grow(int axis, const GridIndex& start) {
  std::vector<int>& sheet = sheets_[position(axis)];
  const Key own = key(axis, start);
  const int number = static_cast<int>(facets_.size());
  BoxFacet grown{axis, start[position(axis)], own[2], {start}};
  sheet[at(axis, start)] = number;
  for (std::size_t i = 0; size_ == FacetSize::largest && i < grown.rectangles.size(); ++i) {
    for (const int along : {(axis + 1) % 3, (axis + 2) % 3}) {
      for (const int step : {-1, 1}) {
        const GridIndex next = moved(grown.rectangles[i], along, step);
        if (next[position(along)] < 0 || next[position(along)] >= grid_.count(along)) continue;
        if (key(axis, next) != own || sheet[at(axis, next)] >= 0) continue;
        sheet[at(axis, next)] = number;
        grown.rectangles.push_back(next);
      }
    }
  }
  facets_.push_back(std::move(grown));
}

}  // namespace etendue
