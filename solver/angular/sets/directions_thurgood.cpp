// SPDX-License-Identifier: AGPL-3.0-or-later
#include <Eigen/Geometry>
#include <cmath>

#include "solver/angular/sets/direction_set.h"
#include "solver/angular/sets/octant.h"

namespace etendue {
namespace {

/// Solid angle of the spherical triangle of three unit vectors (van Oosterom and Strackee 1983).
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 2 * std::atan2(std::abs(a.dot(b.cross(c))), 1 + a.dot(b) + b.dot(c) + c.dot(a));
}

/// The direction of a flat triangle's centroid, with what the sphere sees of the triangle.
void append_triangle(WeightedDirections& octant, const Vec3& a, const Vec3& b, const Vec3& c) {
  octant.directions.push_back((a + b + c).normalized());
  octant.weights.push_back(solid_angle(a.normalized(), b.normalized(), c.normalized()));
}

}  // namespace

// The triangle x + y + z = N, x, y, z >= 0 is cut by planes of whole x, y and z into N^2 equal triangles:
// those that stand upright, and those between them.
DirectionSet directions_thurgood(int order) {
  WeightedDirections octant;
  for (int i = 0; i < order; ++i)
    for (int j = 0; i + j < order; ++j) {
      const Vec3 corner(i, j, order - i - j);
      const Vec3 along_x = corner + Vec3(1, 0, -1), along_y = corner + Vec3(0, 1, -1);
      append_triangle(octant, corner, along_x, along_y);
      if (i + j + 1 < order) append_triangle(octant, along_x, along_y, corner + Vec3(1, 1, -2));
    }
  const WeightedDirections all = mirror_octant(octant);
  return DirectionSet("thurgood", order, all.directions, all.weights);
}

}  // namespace etendue
