// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/solid_angle.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "solver/lights/clipped_polygon.h"
#include "solver/lights/simplex_rules.h"

namespace etendue {
namespace {

/// Distance from a plane, relative to the size, below which the origin lies on it.
constexpr double on_plane = 1e-10;

std::span<const FacePointWeight> points_of(TriangleRule rule) {
  static const std::array<FacePointWeight, 1> one_point = {{{{1. / 3, 1. / 3, 1. / 3}, 1}}};
  if (rule == TriangleRule::one_point) return one_point;
  if (rule == TriangleRule::three_points) return three_point_rule();
  return seven_point_rule();
}

void append_unit(const SphericalTriangle& t, double largest_side, TriangleRule rule,
                 std::vector<SolidAnglePoint>& points) {
  const double side =
      std::max({(t[0] - t[1]).squaredNorm(), (t[1] - t[2]).squaredNorm(), (t[2] - t[0]).squaredNorm()});
  if (side > largest_side * largest_side) {
    const Vec3 ab = (t[0] + t[1]).normalized(), bc = (t[1] + t[2]).normalized(),
               ca = (t[2] + t[0]).normalized();
    append_unit({t[0], ab, ca}, largest_side, rule, points);
    append_unit({ab, t[1], bc}, largest_side, rule, points);
    append_unit({ca, bc, t[2]}, largest_side, rule, points);
    append_unit({ab, bc, ca}, largest_side, rule, points);
    return;
  }
  const double half_determinant = std::abs(t[0].dot(t[1].cross(t[2]))) / 2;
  for (const FacePointWeight& point : points_of(rule)) {
    const Vec3 y = point.barycentric[0] * t[0] + point.barycentric[1] * t[1] + point.barycentric[2] * t[2];
    const double length = y.norm();
    points.push_back({y / length, point.weight * half_determinant / (length * length * length)});
  }
}

struct Side {
  std::array<Vec3, 3> corners;
  Vec3 normal;    ///< out of the tetrahedron
  double offset;  ///< normal.x on the plane; positive: light leaves the tetrahedron here
};

void append_common(const Side& entry, const Side& exit, std::vector<Wedge>& wedges) {
  std::vector<Vec3> cone(entry.corners.begin(), entry.corners.end());
  const auto& c = exit.corners;
  const double turn = c[0].dot(c[1].cross(c[2])) < 0 ? -1 : 1;
  for (std::size_t i = 0; i < 3 && !cone.empty(); ++i)
    cone = clipped(cone, turn * c[i].cross(c[(i + 1) % 3]));
  for (std::size_t i = 2; i < cone.size(); ++i)
    wedges.push_back({{cone[0], cone[i - 1], cone[i]}, entry.normal, entry.offset, exit.normal, exit.offset});
}

}  // namespace

void append_points(const SphericalTriangle& triangle, double largest_side, TriangleRule rule,
                   std::vector<SolidAnglePoint>& points) {
  for (const Vec3& corner : triangle)
    if (corner.isZero()) return;
  append_unit({triangle[0].normalized(), triangle[1].normalized(), triangle[2].normalized()}, largest_side,
              rule, points);
}

std::vector<Wedge> wedges_of(const std::array<Vec3, 4>& vertices) {
  std::vector<Side> entries, exits;
  double size = 0;
  for (const Vec3& vertex : vertices) size = std::max(size, (vertex - vertices[0]).norm());
  for (std::size_t k = 0; k < 4; ++k) {
    Side side{{vertices[(k + 1) % 4], vertices[(k + 2) % 4], vertices[(k + 3) % 4]}, {}, 0};
    side.normal = (side.corners[1] - side.corners[0]).cross(side.corners[2] - side.corners[0]).normalized();
    if (side.normal.dot(vertices[k] - side.corners[0]) > 0) side.normal = -side.normal;
    side.offset = side.normal.dot(side.corners[0]);
    if (std::abs(side.offset) <= on_plane * size) continue;
    (side.offset > 0 ? exits : entries).push_back(side);
  }
  std::vector<Wedge> wedges;
  for (const Side& exit : exits) {
    if (entries.empty()) wedges.push_back({exit.corners, Vec3::Zero(), 0, exit.normal, exit.offset});
    for (const Side& entry : entries) append_common(entry, exit, wedges);
  }
  return wedges;
}

}  // namespace etendue
