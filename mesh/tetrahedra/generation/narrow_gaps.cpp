// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/generation/narrow_gaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/position.h"
#include "mesh/geometry/primitives/sided_facet.h"
#include "mesh/tetrahedra/bounding_box.h"
#include "mesh/tetrahedra/box_grid.h"
#include "mesh/tetrahedra/mesh_faults.h"

namespace etendue {
namespace {

/// Of the largest coordinate. What is nearer touches but for rounding, as points of .poly files do on facets
/// that do not list them.
constexpr double kRounding = 4e-15;
/// Of the diagonal. Over wider gaps TetGen makes cells.
constexpr double kTooNarrow = 1e-9;

/// A facet with all its corners.
struct CornerFacet {
  CornerFacet(const SurfaceFacet& given, const std::vector<Vec3>& points) {
    for (const std::vector<int>& polygon : given.polygons) {
      corners.insert(corners.end(), polygon.begin(), polygon.end());
      for (std::size_t i = 0; i < polygon.size(); ++i)
        if (polygon.size() > 2 || i + 1 < polygon.size())
          facet.edges.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
    }
    facet.inside = points[position(corners.front())];
    facet.normal = normal_of(points);
  }

  bool has_corner(int point) const { return std::ranges::find(corners, point) != corners.end(); }

  Box box(const std::vector<Vec3>& points) const {
    Box box;
    for (const int corner : corners) box.extend(points[position(corner)]);
    return box;
  }

  /// By the corner that is farthest from the first one, and the one that spans the largest triangle with
  /// both.
  Vec3 normal_of(const std::vector<Vec3>& points) const {
    const Vec3& start = points[position(corners.front())];
    Vec3 far = Vec3::Zero();
    for (const int corner : corners) {
      const Vec3 offset = points[position(corner)] - start;
      if (offset.squaredNorm() > far.squaredNorm()) far = offset;
    }
    Vec3 largest = Vec3::Zero();
    for (const int corner : corners) {
      const Vec3 turn = far.cross(points[position(corner)] - start);
      if (turn.squaredNorm() > largest.squaredNorm()) largest = turn;
    }
    return largest.normalized();
  }

  std::vector<int> corners;
  SidedFacet facet;  ///< on either side; `inside` is a corner
};

/// Whether a facet has corners, and all of them are points.
bool is_whole(const SurfaceFacet& facet, std::size_t points) {
  const auto is_point = [&](int corner) { return corner >= 0 && position(corner) < points; };
  return std::ranges::any_of(facet.polygons, [](const auto& polygon) { return !polygon.empty(); }) &&
         std::ranges::all_of(facet.polygons,
                             [&](const auto& polygon) { return std::ranges::all_of(polygon, is_point); });
}

}  // namespace

std::optional<NarrowGap> narrowest_gap(const SurfaceComplex& surface, double part) {
  const BoundingBox around = bounding_box(surface.points);
  const double size = around.diagonal();
  const double rounding = kRounding * around.low.cwiseAbs().cwiseMax(around.high.cwiseAbs()).maxCoeff();
  std::vector<CornerFacet> facets;
  std::vector<Box> boxes;
  for (const SurfaceFacet& facet : surface.facets) {
    if (!is_whole(facet, surface.points.size())) continue;  // TetGen refuses it
    boxes.push_back(facets.emplace_back(facet, surface.points).box(surface.points));
  }
  const BoxGrid grid(boxes, part * size);
  NarrowGap narrowest{part * size, Vec3::Zero()};
  for (int point = 0; point < static_cast<int>(surface.points.size()); ++point) {
    const Vec3& place = surface.points[position(point)];
    for (const std::int32_t facet : grid.candidates(place)) {
      if (facets[position(facet)].has_corner(point)) continue;
      const double width = distance_to_facet(place, surface.points, facets[position(facet)].facet);
      if (width > rounding && width < narrowest.width) narrowest = {width, place};
    }
  }
  return narrowest.width < part * size ? std::optional(narrowest) : std::nullopt;
}

void check_gaps(const SurfaceComplex& surface, const Origin& origin) {
  if (const auto gap = narrowest_gap(surface, kTooNarrow))
    throw InputError(fault_at(
        origin, "",
        fmt::format(
            "a corner at {} nearly but not quite touches a surface (the gap of {:.2g} cannot be meshed); "
            "let them touch, or part them",
            to_text(gap->point), gap->width)));
}

}  // namespace etendue
