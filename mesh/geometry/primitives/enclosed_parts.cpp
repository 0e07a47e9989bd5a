// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/primitives/enclosed_parts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include "base/position.h"
#include "base/segment.h"

namespace etendue {
namespace {

int side_number(const FacetSide& side) { return 2 * side.facet + (side.above ? 1 : 0); }
FacetSide side_of(int number) { return {number / 2, number % 2 == 1}; }

/// Which sides of facets look into the same part of space.
class SideGroups {
 public:
  explicit SideGroups(std::size_t facets) : parent_(2 * facets) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int find(int side) {
    while (parent_[position(side)] != side)
      side = parent_[position(side)] = parent_[position(parent_[position(side)])];
    return side;
  }
  void join(int a, int b) { parent_[position(std::max(find(a), find(b)))] = std::min(find(a), find(b)); }

 private:
  std::vector<int> parent_;
};

/// A facet at an edge, with the angle at which it leaves it.
struct Leaf {
  double angle;
  int facet;
  bool along;  ///< whether the facet has the edge in its own direction
};

/// The leaves of each edge in order around it.
std::map<std::array<int, 2>, std::vector<Leaf>> leaves_by_edge(const std::vector<Vec3>& points,
                                                               const std::vector<SidedFacet>& facets) {
  std::map<std::array<int, 2>, std::vector<Leaf>> leaves;
  for (int f = 0; f < static_cast<int>(facets.size()); ++f) {
    for (const auto& [from, to] : facets[position(f)].edges) {
      const Vec3 edge =
          (points[position(std::max(from, to))] - points[position(std::min(from, to))]).normalized();
      const Vec3 x = edge.unitOrthogonal(), y = edge.cross(x);
      const bool along = from < to;
      const Vec3 into = facets[position(f)].normal.cross(along ? edge : -edge);
      leaves[{std::min(from, to), std::max(from, to)}].push_back(
          {std::atan2(into.dot(y), into.dot(x)), f, along});
    }
  }
  for (auto& [edge, around] : leaves)
    std::sort(around.begin(), around.end(), [](const Leaf& a, const Leaf& b) { return a.angle < b.angle; });
  return leaves;
}

/// Around an edge, the side of one facet that looks forward sees the side of the next that looks back.
SideGroups facing_sides(const std::vector<Vec3>& points, const std::vector<SidedFacet>& facets) {
  SideGroups groups(facets.size());
  for (const auto& [edge, around] : leaves_by_edge(points, facets)) {
    for (std::size_t i = 0; i < around.size(); ++i) {
      const Leaf& leaf = around[i];
      const Leaf& next = around[(i + 1) % around.size()];
      groups.join(side_number({leaf.facet, leaf.along}), side_number({next.facet, !next.along}));
    }
  }
  return groups;
}

/// How far a point of a facet is from its edges.
double width(const Vec3& x, const SidedFacet& facet, const std::vector<Vec3>& points) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : facet.edges)
    nearest = std::min(nearest, distance_to_segment(x, points[position(from)], points[position(to)]));
  return nearest;
}

/// A point before the side of a facet that is nearer to the facet than to anything else.
struct PointBefore {
  Vec3 point = Vec3::Zero();
  double room = -1;  ///< how far its foot is from the edges of the facet and from all other facets

  /// Takes the point before another foot on a facet if there is more room.
  void try_foot(const Vec3& foot, const FacetSide& side, const std::vector<Vec3>& points,
                const std::vector<SidedFacet>& facets) {
    const SidedFacet& facet = facets[position(side.facet)];
    double nearest = width(foot, facet, points);
    for (int other = 0; other < static_cast<int>(facets.size()) && nearest > room; ++other)
      if (other != side.facet)
        nearest = std::min(nearest, distance_to_facet(foot, points, facets[position(other)]));
    if (nearest <= room) return;
    room = nearest;
    point = foot + (side.above ? 0.5 : -0.5) * room * facet.normal;
  }
};

/// A point that a surface looks at: before one of its widest facets.
Vec3 point_before(std::vector<FacetSide> surface, const std::vector<Vec3>& points,
                  const std::vector<SidedFacet>& facets) {
  constexpr std::size_t kTried = 8;
  constexpr double kLittleRoom = 1e-3;  // of the width of the facet
  const auto own_width = [&](const FacetSide& side) {
    const SidedFacet& facet = facets[position(side.facet)];
    return width(facet.inside, facet, points);
  };
  const auto tried = surface.begin() + static_cast<std::ptrdiff_t>(std::min(kTried, surface.size()));
  std::partial_sort(surface.begin(), tried, surface.end(),
                    [&](const FacetSide& a, const FacetSide& b) { return own_width(a) > own_width(b); });
  PointBefore best;
  for (auto side = surface.begin(); side != tried; ++side)
    best.try_foot(facets[position(side->facet)].inside, *side, points, facets);
  if (best.room > kLittleRoom * own_width(surface.front())) return best.point;
  // Something touches all of them in just these points, as a ball does the sides of the box around it.
  for (auto side = surface.begin(); side != tried; ++side) {
    const SidedFacet& facet = facets[position(side->facet)];
    for (const auto& [from, to] : facet.edges) {
      const Vec3 middle = 0.5 * (points[position(from)] + points[position(to)]);
      const Vec3 foot = 0.5 * (facet.inside + middle);
      if (foot_is_inside(foot, points, facet)) best.try_foot(foot, *side, points, facets);
    }
  }
  return best.point;
}

/// Half the solid angle of a triangle, signed: positive where its corners run clockwise as seen from x.
double half_solid_angle(const Vec3& x, const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 a = (p - x).normalized(), b = (q - x).normalized(), c = (r - x).normalized();
  return std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
}

/// The part of all directions from x that a surface fills, 1 inside and 0 outside it.
double winding(const Vec3& x, const std::vector<FacetSide>& surface, const std::vector<Vec3>& points,
               const std::vector<SidedFacet>& facets) {
  double sum = 0;
  for (const FacetSide& side : surface)
    for (const auto& [from, to] : facets[position(side.facet)].edges)
      sum += (side.above ? -1 : 1) * half_solid_angle(x, facets[position(side.facet)].inside,
                                                      points[position(from)], points[position(to)]);
  return sum / (2 * std::numbers::pi);
}

}  // namespace

std::vector<EnclosedPart> enclosed_parts(const std::vector<Vec3>& points,
                                         const std::vector<SidedFacet>& facets) {
  SideGroups groups = facing_sides(points, facets);
  std::map<int, std::vector<FacetSide>> surfaces;
  for (int side = 0; side < 2 * static_cast<int>(facets.size()); ++side)
    surfaces[groups.find(side)].push_back(side_of(side));
  std::vector<EnclosedPart> parts;
  for (const auto& [group, surface] : surfaces) {
    const Vec3 point = point_before(surface, points, facets);
    // Seen from the space around it, a surface fills no solid angle.
    if (winding(point, surface, points, facets) > 0.5) parts.push_back({point, surface});
  }
  return parts;
}

bool encloses(const EnclosedPart& part, const Vec3& x, const std::vector<Vec3>& points,
              const std::vector<SidedFacet>& facets) {
  return winding(x, part.around, points, facets) > 0.5;
}

std::vector<int> depths(const std::vector<EnclosedPart>& parts, const std::vector<Vec3>& points,
                        const std::vector<SidedFacet>& facets) {
  std::vector<int> result;
  for (const EnclosedPart& part : parts)
    result.push_back(
        static_cast<int>(std::count_if(parts.begin(), parts.end(), [&](const EnclosedPart& other) {
          return encloses(other, part.point, points, facets);
        })));
  return result;
}

int part_at(const Vec3& x, const std::vector<EnclosedPart>& parts, const std::vector<int>& depths,
            const std::vector<Vec3>& points, const std::vector<SidedFacet>& facets) {
  int deepest = -1;
  for (int i = 0; i < static_cast<int>(parts.size()); ++i)
    if ((deepest < 0 || depths[position(i)] > depths[position(deepest)]) &&
        encloses(parts[position(i)], x, points, facets))
      deepest = i;
  return deepest;
}

}  // namespace etendue
