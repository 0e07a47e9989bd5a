// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/solid_angle.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "base/clipped_polygon.h"
#include "base/quadrature/simplex_rules.h"

namespace etendue {
namespace {

/// Distance from a plane, relative to the size, below which the origin lies on it.
constexpr double origin_on_plane = 1e-10;
/// From an angle of 1e-10 rad between the corners of a triangle and a plane up to parts of 1e-3 rad there are
/// 34 and 10 cuts.
constexpr int most_plane_cuts = 64;

std::span<const FacePointWeight> points_of(TriangleRule rule) {
  static const std::array<FacePointWeight, 1> one_point = {{{{1. / 3, 1. / 3, 1. / 3}, 1}}};
  if (rule == TriangleRule::one_point) return one_point;
  if (rule == TriangleRule::three_points) return three_point_rule();
  return seven_point_rule();
}

void append_unit_parts(const SphericalTriangle& t, double largest_side, int cuts,
                       std::vector<SphericalTriangle>& parts) {
  check_solid_angle_cuts(cuts);
  const double side =
      std::max({(t[0] - t[1]).squaredNorm(), (t[1] - t[2]).squaredNorm(), (t[2] - t[0]).squaredNorm()});
  if (side > largest_side * largest_side) {
    for (const SphericalTriangle& part : quarters(t)) append_unit_parts(part, largest_side, cuts + 1, parts);
    return;
  }
  parts.push_back(t);
}

/// A face and its plane normal.x = offset; where that is positive light leaves the body here.
struct CutFace {
  const ConvexFace& face;
  double offset;
};

void append_fan(const std::vector<Vec3>& cone, const Wedge& planes, std::vector<Wedge>& wedges) {
  for (std::size_t i = 2; i < cone.size(); ++i) {
    wedges.push_back(planes);
    wedges.back().directions = {cone[0], cone[i - 1], cone[i]};
  }
}

/// Seen from the inside of its plane the corners of a face turn the other way.
std::vector<Vec3> common_cone(const CutFace& entry, const CutFace& exit) {
  std::vector<Vec3> cone = entry.face.corners;
  const std::vector<Vec3>& c = exit.face.corners;
  Vec3 turn = Vec3::Zero();
  for (std::size_t i = 2; i < c.size(); ++i) turn += (c[i - 1] - c[0]).cross(c[i] - c[0]);
  const double sign = turn.dot(exit.face.normal) < 0 ? -1 : 1;
  for (std::size_t i = 0; i < c.size() && !cone.empty(); ++i)
    cone = clipped(cone, sign * c[i].cross(c[(i + 1) % c.size()]));
  return cone;
}

}  // namespace

void check_solid_angle_cuts(int cuts) {
  if (cuts > most_plane_cuts)
    throw std::runtime_error("the solid angle of a surface that is seen edge-on cannot be divided");
}

std::optional<SphericalTriangle> on_sphere(const SphericalTriangle& triangle) {
  for (const Vec3& corner : triangle)
    if (corner == Vec3::Zero()) return std::nullopt;
  return SphericalTriangle{triangle[0].normalized(), triangle[1].normalized(), triangle[2].normalized()};
}

std::array<SphericalTriangle, 4> quarters(const SphericalTriangle& t) {
  const Vec3 ab = (t[0] + t[1]).normalized(), bc = (t[1] + t[2]).normalized(),
             ca = (t[2] + t[0]).normalized();
  return {{{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}}};
}

void append_parts(const SphericalTriangle& triangle, double largest_side,
                  std::vector<SphericalTriangle>& parts) {
  if (const auto unit = on_sphere(triangle)) append_unit_parts(*unit, largest_side, 0, parts);
}

void append_points(const SphericalTriangle& t, TriangleRule rule, std::vector<SolidAnglePoint>& points) {
  const double half_determinant = std::abs(t[0].dot(t[1].cross(t[2]))) / 2;
  for (const FacePointWeight& point : points_of(rule)) {
    const Vec3 y = point.barycentric[0] * t[0] + point.barycentric[1] * t[1] + point.barycentric[2] * t[2];
    const double length = y.norm();
    points.push_back({y / length, point.weight * half_determinant / (length * length * length)});
  }
}

void append_points(const SphericalTriangle& triangle, double largest_side, TriangleRule rule,
                   std::vector<SolidAnglePoint>& points) {
  std::vector<SphericalTriangle> parts;
  append_parts(triangle, largest_side, parts);
  for (const SphericalTriangle& part : parts) append_points(part, rule, points);
}

std::vector<Wedge> wedges_of(std::span<const ConvexFace> faces) {
  std::vector<CutFace> entries, exits;
  double size = 0;
  for (const ConvexFace& face : faces)
    for (const Vec3& corner : face.corners) size = std::max(size, (corner - faces[0].corners[0]).norm());
  for (const ConvexFace& face : faces) {
    const double offset = face.normal.dot(face.corners[0]);
    if (std::abs(offset) <= origin_on_plane * size) continue;
    (offset > 0 ? exits : entries).push_back({face, offset});
  }
  std::vector<Wedge> wedges;
  for (const CutFace& exit : exits) {
    if (entries.empty())
      append_fan(exit.face.corners, {{}, Vec3::Zero(), 0, exit.face.normal, exit.offset}, wedges);
    for (const CutFace& entry : entries)
      append_fan(common_cone(entry, exit),
                 {{}, entry.face.normal, entry.offset, exit.face.normal, exit.offset}, wedges);
  }
  return wedges;
}

std::vector<Wedge> wedges_of(const std::array<Vec3, 4>& vertices) {
  std::array<ConvexFace, 4> faces;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 &a = vertices[(k + 1) % 4], &b = vertices[(k + 2) % 4], &c = vertices[(k + 3) % 4];
    faces[k] = {{a, b, c}, (b - a).cross(c - a).normalized()};
    if (faces[k].normal.dot(vertices[k] - a) > 0) faces[k].normal = -faces[k].normal;
  }
  return wedges_of(faces);
}

}  // namespace etendue
