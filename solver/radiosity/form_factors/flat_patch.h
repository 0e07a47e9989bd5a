// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/radiosity/form_factors/edge_integral.h"
#include "solver/radiosity/form_factors/lambert.h"

namespace etendue {

/// A point of a rule on a surface, with its part of the area.
struct SurfacePoint {
  Vec3 position;
  double area = 0;  ///< [length^2]
};

/// A flat one-sided surface made of triangles that lie in one plane; need be neither convex nor in one piece.
class FlatPatch {
 public:
  /// Triangles counterclockwise seen from the front, in one plane, that do not overlap; at least one.
  explicit FlatPatch(std::vector<TriangleCorners> triangles);
  /// A convex polygon.
  static FlatPatch polygon(Corners corners);

  const std::vector<TriangleCorners>& triangles() const { return triangles_; }
  /// Its outline, as many loops as it takes: edges that two of its triangles share are none of it, and those
  /// in one line are joined.
  const std::vector<ContourEdge>& contour() const { return contour_; }
  /// Seven points of degree 5 of one triangle, else three of degree 2 in each.
  const std::vector<SurfacePoint>& points() const { return points_; }
  /// A point for two numbers in (0, 1), even by area.
  Vec3 point_at(double u, double v) const;
  const Vec3& normal() const { return normal_; }  ///< unit
  double area() const { return area_; }           ///< [length^2]
  const Vec3& centroid() const { return centroid_; }
  double radius() const { return radius_; }                 ///< about the centroid [length]
  double offset() const { return normal_.dot(centroid_); }  ///< normal.x = offset is its plane

 private:
  std::vector<TriangleCorners> triangles_;
  std::vector<ContourEdge> contour_;
  std::vector<SurfacePoint> points_;
  Vec3 normal_ = Vec3::Zero(), centroid_ = Vec3::Zero();
  double area_ = 0, radius_ = 0;
};

}  // namespace etendue
