// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/body_arrangement.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "mesh/geometry/enclosed_parts.h"
#include "mesh/geometry/facet_triangles.h"
#include "mesh/geometry/plane_arrangement.h"
#include "mesh/geometry/primitive_checks.h"

namespace etendue {
namespace {

/// TetGen takes points for one that are closer than this part of the scene's size.
constexpr double kSmallestGap = 1e-8;

std::size_t n(int i) { return static_cast<std::size_t>(i); }

std::array<int, 2> sorted(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

struct ByCoordinates {
  bool operator()(const ExactPoint& a, const ExactPoint& b) const {
    return CGAL::compare_xyz(a, b) == CGAL::SMALLER;
  }
};

/// The corners of all facets, each once.
class Corners {
 public:
  explicit Corners(const std::vector<ExactFacet>& facets) {
    for (const ExactFacet& facet : facets)
      for (const auto& [from, to] : facet.edges) {
        numbers_.try_emplace(from, 0);
        numbers_.try_emplace(to, 0);
      }
    for (auto& [point, number] : numbers_) {
      number = static_cast<int>(exact_.size());
      exact_.push_back(point);
      rounded_.push_back(rounded(point));
    }
  }

  const std::vector<Vec3>& points() const { return rounded_; }
  const ExactPoint& exact(int corner) const { return exact_[n(corner)]; }

  /// The edge in the pieces that the corners of other facets on it cut it into.
  std::vector<std::array<int, 2>> pieces(const std::array<ExactPoint, 2>& edge) const {
    const bool rising = ByCoordinates{}(edge[0], edge[1]);
    const int first = numbers_.at(edge[rising ? 0 : 1]), last = numbers_.at(edge[rising ? 1 : 0]);
    // Corners are sorted as along the edge: what lies on it stands between its ends.
    std::vector<std::array<int, 2>> result;
    int start = first;
    for (int i = first + 1; i <= last; ++i) {
      if (i < last &&
          !(is_near(i, first, last) && CGAL::collinear(exact_[n(first)], exact_[n(i)], exact_[n(last)])))
        continue;
      result.push_back(rising ? std::array{start, i} : std::array{i, start});
      start = i;
    }
    return result;
  }

 private:
  bool is_near(int i, int first, int last) const {
    const Vec3 along = rounded_[n(last)] - rounded_[n(first)], offset = rounded_[n(i)] - rounded_[n(first)];
    const double t = std::clamp(offset.dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (offset - t * along).norm() <= 1e-9 * along.norm();
  }

  std::map<ExactPoint, int, ByCoordinates> numbers_;
  std::vector<ExactPoint> exact_;
  std::vector<Vec3> rounded_;
};

std::vector<SidedFacet> sided(const std::vector<ExactFacet>& facets, const Corners& corners) {
  std::vector<SidedFacet> result;
  for (const ExactFacet& facet : facets) {
    SidedFacet own{{}, facet.normal, rounded(facet.inside)};
    for (const auto& edge : facet.edges)
      for (const auto& piece : corners.pieces(edge)) own.edges.push_back(piece);
    result.push_back(std::move(own));
  }
  return result;
}

/// Corners that others touch the inside of a facet with.
std::vector<int> touching_corners(const ExactFacet& facet, const SidedFacet& own, const Corners& corners) {
  const std::vector<Vec3>& points = corners.points();
  std::set<int> known;
  double size = 0;
  for (const auto& edge : own.edges) {
    known.insert(edge.begin(), edge.end());
    size = std::max(size, (points[n(edge[0])] - own.inside).norm());
  }
  std::vector<int> touching;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    const double height = std::abs(own.normal.dot(points[n(i)] - own.inside));
    if (height > 1e-9 * size || known.contains(i) || !foot_is_inside(points[n(i)], points, own)) continue;
    if (facet.plane.has_on(corners.exact(i))) touching.push_back(i);
  }
  return touching;
}

BodyScene scene_of(const Geometry& geometry, std::vector<std::string>& region_names) {
  BodyScene scene{geometry, primitive_labels(geometry, region_names), {}, named_rectangles(geometry)};
  const SnapPlanes snap = snap_planes(geometry);
  for (const Primitive& primitive : geometry.primitives) scene.bodies.push_back(convex_body(primitive, snap));
  return scene;
}

void check_gaps(const Geometry& geometry, const std::vector<Vec3>& points,
                const std::vector<SidedFacet>& facets) {
  Vec3 low = points.front(), high = points.front();
  for (const Vec3& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  for (const SidedFacet& facet : facets) {
    for (const auto& [from, to] : facet.edges) {
      const double gap = (points[n(from)] - points[n(to)]).norm();
      if (gap > kSmallestGap * (high - low).norm()) continue;
      throw InputError(fault_at(
          base_of(geometry.primitives.back()).origin, "",
          fmt::format("primitives cross within {:.2g} of each other near {} (too close to be meshed); "
                      "let them overlap, part them or make their coordinates equal",
                      gap, text_of(points[n(from)]))));
    }
  }
}

void add_seeds(const std::vector<ExactFacet>& facets, const std::vector<SidedFacet>& sided_facets,
               SurfaceComplex& surface) {
  for (const EnclosedPart& part : enclosed_parts(surface.points, sided_facets)) {
    const FacetSide& side = part.around.front();
    const SpaceLabel label = side.above ? facets[n(side.facet)].above : facets[n(side.facet)].below;
    if (is_void(label))
      surface.holes.push_back(part.point);
    else
      surface.seeds.push_back({part.point, label});
  }
}

bool is_along_axes(const ExactPlane& plane) {
  return (plane.a() == 0) + (plane.b() == 0) + (plane.c() == 0) == 2;
}

/// A facet along the axes as a whole: rounding keeps it flat. Another one in triangles, which stay flat;
/// TetGen fails on many-sided facets that are flat only to rounding.
void add_facet(const ExactFacet& facet, const SidedFacet& own, const Corners& corners,
               SurfaceComplex& surface) {
  const std::vector<int> lone = touching_corners(facet, own, corners);
  if (is_along_axes(facet.plane)) {
    SurfaceFacet whole{{}, {}, facet.wall};
    std::set<std::array<int, 2>> written;
    for (const auto& [from, to] : own.edges)
      if (written.insert(sorted(from, to)).second) whole.polygons.push_back({from, to});
    for (const int corner : lone) whole.polygons.push_back({corner});
    for (const ExactPoint& opening : facet.openings) whole.openings.push_back(rounded(opening));
    surface.facets.push_back(std::move(whole));
    return;
  }
  int axis = 0;
  facet.normal.maxCoeff(&axis);
  const auto point = [&](int corner) -> const ExactPoint& { return corners.exact(corner); };
  for (const auto& [a, b, c] : facet_triangles(own.edges, lone, axis, point))
    surface.facets.push_back({{{a, b, c}}, {}, facet.wall});
}

}  // namespace

SurfaceComplex arrange_bodies(const Geometry& geometry) {
  SurfaceComplex surface;
  const BodyScene scene = scene_of(geometry, surface.region_names);
  WallNames walls;
  std::set<int> used_patches;
  std::vector<ExactFacet> facets;
  for (const FacePlane& plane : face_planes(scene))
    for (ExactFacet& facet : facets_in_plane(plane, scene, walls, used_patches))
      facets.push_back(std::move(facet));

  std::vector<Fault> faults;
  for (int patch = 0; patch < static_cast<int>(geometry.patches.size()); ++patch)
    if (!used_patches.contains(patch)) faults.push_back(patch_covers_nothing(geometry.patches[n(patch)]));
  if (!faults.empty()) throw InputError(std::move(faults));
  if (facets.empty()) return surface;

  const Corners corners(facets);
  const std::vector<SidedFacet> sided_facets = sided(facets, corners);
  check_gaps(geometry, corners.points(), sided_facets);
  surface.points = corners.points();
  surface.wall_names = walls.all();
  for (std::size_t f = 0; f < facets.size(); ++f) add_facet(facets[f], sided_facets[f], corners, surface);
  add_seeds(facets, sided_facets, surface);
  return surface;
}

}  // namespace etendue
