// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/arrangement/body_arrangement.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

#include "base/position.h"
#include "mesh/geometry/arrangement/facet_triangles.h"
#include "mesh/geometry/arrangement/plane_arrangement.h"
#include "mesh/geometry/arrangement/smallest_gap.h"
#include "mesh/geometry/primitives/enclosed_parts.h"
#include "mesh/geometry/primitives/primitive_checks.h"
#include "mesh/geometry/primitives/sheet_shape.h"

namespace etendue {
namespace {

/// Corners nearer than this part of the scene's size are one whatever is asked for: only rounding of the
/// bodies keeps them apart.
constexpr double kRoundingGap = 1e-12;

std::array<int, 2> sorted(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

struct ByCoordinates {
  bool operator()(const ExactPoint& a, const ExactPoint& b) const {
    return CGAL::compare_xyz(a, b) == CGAL::SMALLER;
  }
};

/// The corners of all facets, each once.
class Corners {
 public:
  Corners(const std::vector<ExactFacet>& facets, const std::vector<ConvexBody>& bodies,
          const SnapPlanes& planes) {
    // On slender triangles across an oblique ring of many corners TetGen fails; around a middle there are
    // none.
    for (const ConvexBody& body : bodies)
      for (const ExactPoint& middle : body.middles) numbers_.try_emplace(middle, 0);
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
    merge_near(planes);
  }

  /// The corner that replaces this one and all within the snap distance of it.
  int merged(int corner) const { return merged_[position(corner)]; }

  const std::vector<Vec3>& points() const { return rounded_; }
  const ExactPoint& exact(int corner) const { return exact_[position(corner)]; }

  /// The edge in the pieces that the corners of other facets on it cut it into.
  std::vector<std::array<int, 2>> pieces(const std::array<ExactPoint, 2>& edge) const {
    const bool rising = ByCoordinates{}(edge[0], edge[1]);
    const int first = numbers_.at(edge[rising ? 0 : 1]), last = numbers_.at(edge[rising ? 1 : 0]);
    // Corners are sorted as along the edge: what lies on it stands between its ends.
    std::vector<std::array<int, 2>> result;
    int start = first;
    for (int i = first + 1; i <= last; ++i) {
      if (i < last &&
          !(is_near(i, first, last) &&
            CGAL::collinear(exact_[position(first)], exact_[position(i)], exact_[position(last)])))
        continue;
      result.push_back(rising ? std::array{start, i} : std::array{i, start});
      start = i;
    }
    return result;
  }

 private:
  void merge_near(const SnapPlanes& planes) {
    Eigen::AlignedBox3d extent;
    for (const Vec3& point : rounded_) extent.extend(point);
    const double gap = std::max(planes.distance, kRoundingGap * extent.diagonal().norm());
    merged_.resize(rounded_.size());
    for (int i = 0; i < static_cast<int>(rounded_.size()); ++i) {
      merged_[position(i)] = i;
      // Corners are sorted by x first.
      for (int j = i - 1; j >= 0 && rounded_[position(i)].x() - rounded_[position(j)].x() <= gap; --j) {
        if ((rounded_[position(i)] - rounded_[position(j)]).norm() > gap) continue;
        merged_[position(i)] = merged_[position(j)];
        keep_on_planes(rounded_[position(merged_[position(j)])], rounded_[position(i)], planes);
        break;
      }
    }
  }

  /// A corner on the side of a box stays there.
  static void keep_on_planes(Vec3& corner, const Vec3& other, const SnapPlanes& planes) {
    for (int axis = 0; axis < 3; ++axis) {
      const std::vector<double>& sides = planes.sides[position(axis)];
      if (std::find(sides.begin(), sides.end(), other[axis]) != sides.end()) corner[axis] = other[axis];
    }
  }

  bool is_near(int i, int first, int last) const {
    const Vec3 along = rounded_[position(last)] - rounded_[position(first)],
               offset = rounded_[position(i)] - rounded_[position(first)];
    const double t = std::clamp(offset.dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (offset - t * along).norm() <= 1e-9 * along.norm();
  }

  std::map<ExactPoint, int, ByCoordinates> numbers_;
  std::vector<ExactPoint> exact_;
  std::vector<Vec3> rounded_;
  std::vector<int> merged_;
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
    size = std::max(size, (points[position(edge[0])] - own.inside).norm());
  }
  std::vector<int> touching;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    const double height = std::abs(own.normal.dot(points[position(i)] - own.inside));
    if (height > 1e-9 * size || known.contains(i) || !foot_is_inside(points[position(i)], points, own))
      continue;
    if (facet.plane.has_on(corners.exact(i))) touching.push_back(i);
  }
  return touching;
}

BodyScene scene_of(const Geometry& geometry, std::vector<std::string>& region_names) {
  BodyScene scene{geometry, primitive_labels(geometry, region_names), {}, named_rectangles(geometry), {}};
  const SnapPlanes snap = snap_planes(geometry);
  for (const Primitive& primitive : geometry.primitives) scene.bodies.push_back(convex_body(primitive, snap));
  for (int i = 0; i < static_cast<int>(geometry.sheets.size()); ++i)
    for (SheetTriangle& triangle : sheet_triangles(geometry.sheets[position(i)], i))
      scene.sheets.push_back(std::move(triangle));
  return scene;
}

/// The facet between merged corners, without the edges that have gone.
SidedFacet merged(SidedFacet facet, const Corners& corners) {
  for (auto& edge : facet.edges) edge = {corners.merged(edge[0]), corners.merged(edge[1])};
  std::erase_if(facet.edges, [](const std::array<int, 2>& edge) { return edge[0] == edge[1]; });
  return facet;
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
    SurfaceFacet whole{{}, {}, facet.wall, facet.sheet};
    std::set<std::array<int, 2>> written;
    for (const auto& [from, to] : merged(own, corners).edges)
      if (written.insert(sorted(from, to)).second) whole.polygons.push_back({from, to});
    for (const int corner : lone) whole.polygons.push_back({corners.merged(corner)});
    for (const ExactPoint& opening : facet.openings) whole.openings.push_back(rounded(opening));
    if (written.size() > 2) surface.facets.push_back(std::move(whole));
    return;
  }
  int axis = 0;
  facet.normal.maxCoeff(&axis);
  const auto point = [&](int corner) -> const ExactPoint& { return corners.exact(corner); };
  for (const std::array<int, 3>& triangle : facet_triangles(own.edges, lone, axis, point)) {
    const int a = corners.merged(triangle[0]), b = corners.merged(triangle[1]),
              c = corners.merged(triangle[2]);
    if (a != b && b != c && c != a) surface.facets.push_back({{{a, b, c}}, {}, facet.wall, facet.sheet});
  }
}

void add_seeds(const std::vector<ExactFacet>& facets, const std::vector<SidedFacet>& sided_facets,
               const Corners& corners, SurfaceComplex& surface) {
  std::vector<SidedFacet> whole;
  std::vector<std::array<SpaceLabel, 2>> labels;  // below, above
  for (std::size_t f = 0; f < facets.size(); ++f) {
    SidedFacet facet = merged(sided_facets[f], corners);
    if (facet.edges.size() < 3) continue;
    whole.push_back(std::move(facet));
    labels.push_back({facets[f].below, facets[f].above});
  }
  for (const EnclosedPart& part : enclosed_parts(surface.points, whole)) {
    const FacetSide& side = part.around.front();
    const SpaceLabel label = labels[position(side.facet)][side.above ? 1 : 0];
    if (is_void(label))
      surface.holes.push_back(part.point);
    else
      surface.seeds.push_back({part.point, label});
  }
}

/// Points that merging has left unused would be meshed too.
void drop_unused_points(SurfaceComplex& surface) {
  std::vector<int> number(surface.points.size(), -1);
  std::vector<Vec3> used;
  for (SurfaceFacet& facet : surface.facets) {
    for (std::vector<int>& polygon : facet.polygons) {
      for (int& point : polygon) {
        if (number[position(point)] < 0) {
          number[position(point)] = static_cast<int>(used.size());
          used.push_back(surface.points[position(point)]);
        }
        point = number[position(point)];
      }
    }
  }
  surface.points = std::move(used);
}

/// Refuses edges that are too short for TetGen.
void check_gaps(const Geometry& geometry, const SurfaceComplex& surface) {
  Eigen::AlignedBox3d extent;
  for (const Vec3& point : surface.points) extent.extend(point);
  for (const SurfaceFacet& facet : surface.facets) {
    for (const std::vector<int>& polygon : facet.polygons) {
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &from = surface.points[position(polygon[i])],
                   &to = surface.points[position(polygon[(i + 1) % polygon.size()])];
        const double gap = (from - to).norm();
        if (polygon.size() == 1 || gap > smallest_gap * extent.diagonal().norm()) continue;
        throw InputError(fault_at(
            base_of(geometry.primitives.back()).origin, "",
            fmt::format("primitives cross within {:.2g} of each other near {} (too close to be meshed); "
                        "let them overlap, part them or make their coordinates equal",
                        gap, text_of(from))));
      }
    }
  }
}

/// Names the sides of the sheets, which keep their numbers.
void add_sheets(const Geometry& geometry, const std::vector<ExactFacet>& facets, WallNames& walls,
                SurfaceComplex& surface, std::vector<Fault>& faults) {
  for (int i = 0; i < static_cast<int>(geometry.sheets.size()); ++i) {
    const Sheet& sheet = geometry.sheets[position(i)];
    if (std::none_of(facets.begin(), facets.end(), [&](const ExactFacet& facet) { return facet.sheet == i; }))
      faults.push_back(sheet_is_nowhere(sheet));
    surface.sheets.push_back({walls.number(sheet.front), walls.number(sheet.back), sheet_normal(sheet)});
  }
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
    if (!used_patches.contains(patch))
      faults.push_back(patch_covers_nothing(geometry.patches[position(patch)]));
  add_sheets(geometry, facets, walls, surface, faults);
  if (!faults.empty()) throw InputError(std::move(faults));
  if (facets.empty()) return surface;

  const Corners corners(facets, scene.bodies, snap_planes(geometry));
  const std::vector<SidedFacet> sided_facets = sided(facets, corners);
  surface.points = corners.points();
  surface.wall_names = walls.all();
  for (std::size_t f = 0; f < facets.size(); ++f) add_facet(facets[f], sided_facets[f], corners, surface);
  check_gaps(geometry, surface);
  add_seeds(facets, sided_facets, corners, surface);
  drop_unused_points(surface);
  return surface;
}

}  // namespace etendue
