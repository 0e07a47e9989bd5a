// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// A direction and its part of a solid angle [sr].
struct SolidAnglePoint {
  Vec3 direction;
  double weight;
};

/// Directions between three corners (vectors of any length, seen from the origin), of less than a half space.
using SphericalTriangle = std::array<Vec3, 3>;

/// Throws std::runtime_error where the solid angle of a triangle has been cut in four so often that the
/// origin must lie in the triangle. Each cut halves the sides, or, where the origin nearly lies in the
/// triangle, doubles the angle between its corners and the plane beside them.
void check_solid_angle_cuts(int cuts);

/// With unit corners; empty where one of them is the origin.
std::optional<SphericalTriangle> on_sphere(const SphericalTriangle& triangle);
/// Four parts of a triangle with unit corners, again with unit corners.
std::array<SphericalTriangle, 4> quarters(const SphericalTriangle& triangle);

/// Points of a rule in a triangle: degree 1, 2 or 5.
enum class TriangleRule { one_point, three_points, seven_points };

/// Appends the parts of a triangle that is split in four until its sides are at most `largest_side` (chords
/// of the unit sphere), with unit corners. Throws std::runtime_error where that has no end.
void append_parts(const SphericalTriangle& triangle, double largest_side,
                  std::vector<SphericalTriangle>& parts);
/// Appends points of a rule for the solid angle of a triangle with unit corners: those of the rule in the
/// flat triangle of its corners, y, with dw = det(a, b, c) / |y|^3.
void append_points(const SphericalTriangle& triangle, TriangleRule rule,
                   std::vector<SolidAnglePoint>& points);
/// Of the parts of a triangle.
void append_points(const SphericalTriangle& triangle, double largest_side, TriangleRule rule,
                   std::vector<SolidAnglePoint>& points);

/// A flat face of a convex body.
struct ConvexFace {
  std::vector<Vec3> corners;  ///< in order about the face
  Vec3 normal;                ///< outward
};

/// A convex body seen from the origin falls into wedges: directions that come in by one plane and go out by
/// another, so that all that is integrated over a wedge is smooth.
struct Wedge {
  SphericalTriangle directions = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  Vec3 entry_normal = Vec3::Zero();  ///< of the plane n.x = entry; zero where the origin is inside
  double entry = 0;
  Vec3 exit_normal = Vec3::Zero();
  double exit = 0;

  double distance_in(const Vec3& direction) const {
    return entry_normal == Vec3::Zero() ? 0 : entry / entry_normal.dot(direction);
  }
  double distance_out(const Vec3& direction) const { return exit / exit_normal.dot(direction); }
};

/// The origin may lie inside, outside, or on a face, an edge or a vertex: faces whose plane it lies on to
/// 1e-10 of the size take no solid angle.
std::vector<Wedge> wedges_of(std::span<const ConvexFace> faces);
/// Those of a tetrahedron.
std::vector<Wedge> wedges_of(const std::array<Vec3, 4>& vertices);

}  // namespace etendue
