// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/sources/shadow_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/clipped_polygon.h"
#include "solver/uncollided/closed_form/outline.h"
#include "solver/uncollided/sources/beam_source.h"
#include "solver/uncollided/sources/point_source.h"

namespace etendue {
namespace {

/// Part of a size within which a point lies on a plane.
constexpr double point_on_plane = 1e-9;
/// Planes behind shadow edges of one cell or face that are distinguished, and of an image in all.
constexpr std::size_t most_planes = 64, most_in_all = 20000;

/// Returns whether light of this direction meets something abrupt at a shadow edge: passes over an edge,
/// beyond which there is nothing of the surface, or comes in beside it or through a medium on one of its
/// sides. `by_mirrors` says that it may come from mirrors.
bool is_abrupt(const ShadowEdge& edge, const Vec3& direction, std::span<const int> lit_walls,
               bool by_mirrors) {
  const Vec3 across = (edge.end - edge.begin).cross(direction);
  struct {
    bool some = false, right = false, left = false;
    void add(double side, double along) {
      some = true;
      right = right || side > along;
      left = left || side < -along;
    }
    bool end_here() const { return some && !(right && left); }
  } walls, media;
  bool lit = false, by_mirror = false;
  for (const ShadowEdge::Surface& surface : edge.surfaces) {
    (surface.wall < 0 ? media : walls).add(across.dot(surface.away), point_on_plane * across.norm());
    if (surface.wall < 0) continue;
    lit = lit || (surface.normal.dot(direction) < 0 && std::ranges::count(lit_walls, surface.wall) > 0);
    by_mirror = by_mirror || (by_mirrors && surface.mirrors);
  }
  const bool over_edge = walls.end_here() || media.end_here();
  if (edge.blunt) return over_edge;
  return over_edge || lit || by_mirror || media.some;
}

std::optional<ShadowPlane> plane_behind(const Vec3& begin, const Vec3& end, const Vec3& place,
                                        const Vec3& beam) {
  const bool is_point = beam.isZero();
  const Vec3 a = begin - place, b = end - place;
  const Vec3 normal = is_point ? a.cross(b) : (b - a).cross(beam);
  const double scale = is_point ? a.norm() * b.norm() : (b - a).norm();
  if (normal.norm() <= point_on_plane * scale) return std::nullopt;
  const auto half = [&](const Vec3& across, const Vec3& at) {
    const Vec3 unit = across.normalized();
    return ShadowPlane::Half{unit, is_point ? 0 : unit.dot(at)};
  };
  ShadowPlane plane;
  plane.plane = half(normal, a);
  plane.begin = is_point ? half(normal.cross(a), a) : half(beam.cross(normal), a);
  plane.end = is_point ? half(b.cross(normal), b) : half(normal.cross(beam), b);
  plane.nearest = is_point ? distance_to_side(Vec3::Zero(), a, b) : std::min(beam.dot(begin), beam.dot(end));
  return plane;
}

/// Returns whether a convex body with these points on the plane lies beside the part of the plane that
/// counts.
bool lie_beside(std::span<const Vec3> on, const ShadowPlane& plane, double tolerance) {
  const auto beyond = [&](const ShadowPlane::Half& half) {
    return std::ranges::all_of(on, [&](const Vec3& p) { return half.above(p) <= tolerance; });
  };
  return beyond(plane.begin) || beyond(plane.end);
}

/// Where the edges between any two corners meet the plane.
std::vector<Vec3> points_on(const ShadowPlane& plane, std::span<const Vec3> corners, double tolerance) {
  std::vector<Vec3> on;
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double at_i = plane.plane.above(corners[i]), at_j = plane.plane.above(corners[j]);
      if ((at_i > tolerance && at_j < -tolerance) || (at_i < -tolerance && at_j > tolerance))
        on.emplace_back((at_i * corners[j] - at_j * corners[i]) / (at_i - at_j));
    }
  for (const Vec3& corner : corners)
    if (std::abs(plane.plane.above(corner)) <= tolerance) on.push_back(corner);
  return on;
}

bool is_cut(std::span<const Vec3> corners, const ShadowPlane& plane, double tolerance) {
  bool above = false, below = false;
  for (const Vec3& corner : corners) {
    above = above || plane.plane.above(corner) > tolerance;
    below = below || plane.plane.above(corner) < -tolerance;
  }
  return above && below && !lie_beside(points_on(plane, corners, tolerance), plane, tolerance);
}

ShadowPlane moved(ShadowPlane plane, const Vec3& by) {
  for (ShadowPlane::Half* half : {&plane.plane, &plane.begin, &plane.end})
    half->offset += half->normal.dot(by);
  return plane;
}

}  // namespace

std::vector<std::array<Vec3, 3>> cut_by_planes(const std::array<Vec3, 3>& triangle,
                                               std::span<const ShadowPlane> planes) {
  if (planes.empty()) return {triangle};
  const double tolerance =
      point_on_plane * std::max((triangle[1] - triangle[0]).norm(), (triangle[2] - triangle[0]).norm());
  std::vector<std::vector<Vec3>> pieces{{triangle.begin(), triangle.end()}};
  for (const ShadowPlane& plane : planes)
    for (std::size_t i = 0, count = pieces.size(); i < count; ++i) {
      if (!is_cut(pieces[i], plane, tolerance)) continue;
      const Vec3 &normal = plane.plane.normal, on = plane.plane.offset * normal;
      std::vector<Vec3> below = clipped(pieces[i], -normal, on, tolerance);
      pieces[i] = clipped(pieces[i], normal, on, tolerance);
      pieces.push_back(std::move(below));
    }
  std::vector<std::array<Vec3, 3>> triangles;
  for (const std::vector<Vec3>& piece : pieces)
    for (std::size_t i = 2; i < piece.size(); ++i) triangles.push_back({piece[0], piece[i - 1], piece[i]});
  return triangles;
}

ShadowPlanes::ShadowPlanes(const LightPaths& paths, const std::vector<ShadowEdge>& shadow_edges,
                           const LightSource& source) {
  const PointSource* point = source.as_point();
  const BeamSource* beam = source.as_beam();
  if (point == nullptr && beam == nullptr) return;
  if (point != nullptr)
    for (const PointSource::Image& image : point->images()) {
      images_.push_back({image.position, Vec3::Zero(), {}});
      add_planes(shadow_edges, copies_behind(paths.mirrors(), image.mirrors), {}, images_.back());
      for (const std::vector<Vec3>& rim : point->rims(image)) add_rim(rim, images_.back());
    }
  else
    for (std::size_t i = 0; i < beam->directions().size(); ++i) {
      const Vec3& direction = beam->directions()[i];
      const std::vector<MirrorCopy> copies = copies_along(paths, beam->mirrors()[i], direction);
      images_.push_back({Vec3::Zero(), direction, {}});
      add_planes(shadow_edges, copies, beam->light().walls, images_.back());
      complete_ = complete_ && !copies.empty();
    }
}

ShadowPlanes::ShadowPlanes(const LightPaths& paths, const std::vector<ShadowEdge>& shadow_edges,
                           const Vec3& eye, MirrorSet mirrors) {
  images_.push_back({eye, Vec3::Zero(), {}});
  add_planes(shadow_edges, copies_behind(paths.mirrors(), mirrors), {}, images_.back());
}

// Light via mirrors has come straight through the space behind them, where each shadow edge stands
// again.
void ShadowPlanes::add_planes(const std::vector<ShadowEdge>& shadow_edges,
                              const std::vector<MirrorCopy>& copies, std::span<const int> lit_walls,
                              Image& image) {
  const bool is_point = image.direction.isZero();
  for (const MirrorCopy& copy : copies)
    for (const ShadowEdge& edge : shadow_edges) {
      const Vec3 begin = copy.point(edge.begin), end = copy.point(edge.end);
      const Vec3 here = is_point ? (begin + end) / 2 - image.place : image.direction;
      if (!is_abrupt(edge, copy.direction_in_room(here), lit_walls, copies.size() > 1)) continue;
      if (const auto plane = plane_behind(begin, end, image.place, image.direction))
        image.planes.push_back(*plane);
      if (image.planes.size() > most_in_all) {
        image.planes.clear();
        complete_ = false;
        return;
      }
    }
}

// It begins at the lamp itself.
void ShadowPlanes::add_rim(std::span<const Vec3> rim, Image& image) {
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Vec3 &begin = rim[i], &end = rim[(i + 1) % rim.size()];
    if (auto plane = plane_behind(begin, end, Vec3::Zero(), Vec3::Zero())) {
      plane->nearest = 0;
      image.planes.push_back(*plane);
      ++image.along_rims;
    }
  }
}

bool ShadowPlanes::find(std::size_t number, std::span<const Vec3> corners,
                        std::vector<ShadowPlane>& found) const {
  const Image& image = images_[number];
  found.clear();
  std::array<Vec3, 4> about;
  double farthest = -std::numeric_limits<double>::infinity(), radius = 0;
  Vec3 middle = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    about[i] = corners[i] - image.place;
    middle += about[i] / static_cast<double>(corners.size());
    farthest = std::max(farthest, image.direction.isZero() ? about[i].norm() : image.direction.dot(about[i]));
  }
  const std::span<const Vec3> seen(about.data(), corners.size());
  for (const Vec3& corner : seen) radius = std::max(radius, (corner - middle).norm());
  const double tolerance = point_on_plane * radius;
  for (const ShadowPlane& plane : image.planes) {
    if (std::abs(plane.plane.above(middle)) >= radius || plane.nearest >= farthest - tolerance ||
        plane.begin.above(middle) <= -radius || plane.end.above(middle) <= -radius ||
        !is_cut(seen, plane, tolerance))
      continue;
    if (found.size() == most_planes + image.along_rims) {
      found.clear();
      return false;
    }
    found.push_back(plane);
  }
  return complete_;
}

bool ShadowPlanes::find(std::span<const Vec3> corners, std::vector<ShadowPlane>& found) const {
  std::vector<ShadowPlane> of_image;
  bool all = true;
  std::size_t most = most_planes;
  found.clear();
  for (std::size_t i = 0; i < images_.size(); ++i) {
    most += images_[i].along_rims;
    all = find(i, corners, of_image) && all;
    for (const ShadowPlane& plane : of_image) found.push_back(moved(plane, images_[i].place));
  }
  if (found.size() <= most) return all;
  found.clear();
  return false;
}

bool ShadowPlanes::pass_through(std::span<const Vec3> corners) const {
  std::vector<ShadowPlane> found;
  for (std::size_t i = 0; i < images_.size(); ++i)
    if ((!find(i, corners, found) && complete_) || !found.empty()) return true;
  return false;
}

}  // namespace etendue
