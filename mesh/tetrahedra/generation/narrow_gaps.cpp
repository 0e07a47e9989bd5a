// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/generation/narrow_gaps.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>

#include "base/position.h"
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

/// The plane and the edges of a facet.
class FacetShape {
 public:
  FacetShape(const SurfaceFacet& facet, const std::vector<Vec3>& points) : points_(points) {
    for (const std::vector<int>& polygon : facet.polygons) {
      corners_.insert(corners_.end(), polygon.begin(), polygon.end());
      for (std::size_t i = 0; i < polygon.size(); ++i)
        if (polygon.size() > 2 || i + 1 < polygon.size())
          edges_.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
    }
    set_plane();
  }

  bool has_corner(int point) const {
    return std::find(corners_.begin(), corners_.end(), point) != corners_.end();
  }

  Box box() const {
    Box box;
    for (const int corner : corners_) box.extend(points_[position(corner)]);
    return box;
  }

  double distance(const Vec3& x) const {
    const Vec3& start = points_[position(corners_.front())];
    const double height = normal_.dot(x - start);
    if (holds(x - height * normal_)) return std::abs(height);
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [from, to] : edges_) {
      const Vec3 &p = points_[position(from)], along = points_[position(to)] - p;
      const double t = std::clamp((x - p).dot(along) / along.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (x - p - t * along).norm());
    }
    return nearest;
  }

 private:
  /// By the corner that is farthest from the first one, and the one that spans the largest triangle with
  /// both.
  void set_plane() {
    const Vec3& start = points_[position(corners_.front())];
    Vec3 far = Vec3::Zero();
    for (const int corner : corners_) {
      const Vec3 offset = points_[position(corner)] - start;
      if (offset.squaredNorm() > far.squaredNorm()) far = offset;
    }
    Vec3 largest = Vec3::Zero();
    for (const int corner : corners_) {
      const Vec3 turn = far.cross(points_[position(corner)] - start);
      if (turn.squaredNorm() > largest.squaredNorm()) largest = turn;
    }
    normal_ = largest.normalized();
  }

  /// Whether a point of the plane lies inside the outlines.
  bool holds(const Vec3& x) const {
    int axis = 0;
    normal_.cwiseAbs().maxCoeff(&axis);
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    bool is_inside = false;  // changes with each edge that a ray in the plane crosses
    for (const auto& [from, to] : edges_) {
      const Vec3 &p = points_[position(from)], &q = points_[position(to)];
      if ((p[b] > x[b]) == (q[b] > x[b])) continue;
      if (x[c] < p[c] + (x[b] - p[b]) / (q[b] - p[b]) * (q[c] - p[c])) is_inside = !is_inside;
    }
    return is_inside;
  }

  const std::vector<Vec3>& points_;
  std::vector<int> corners_;
  std::vector<std::array<int, 2>> edges_;
  Vec3 normal_ = Vec3::Zero();
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
  std::vector<FacetShape> facets;
  std::vector<Box> boxes;
  for (const SurfaceFacet& facet : surface.facets) {
    if (!is_whole(facet, surface.points.size())) continue;  // TetGen refuses it
    boxes.push_back(facets.emplace_back(facet, surface.points).box());
  }
  const BoxGrid grid(boxes, part * size);
  NarrowGap narrowest{part * size, Vec3::Zero()};
  for (int point = 0; point < static_cast<int>(surface.points.size()); ++point) {
    const Vec3& place = surface.points[position(point)];
    for (const std::int32_t facet : grid.candidates(place)) {
      if (facets[position(facet)].has_corner(point)) continue;
      const double width = facets[position(facet)].distance(place);
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
