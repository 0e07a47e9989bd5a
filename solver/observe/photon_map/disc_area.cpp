// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/photon_map/disc_area.h"

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

/// Twice the area of the sector between two directions.
double sector(const Vec3& a, const Vec3& b, const Vec3& normal, double radius) {
  return radius * radius * std::atan2(a.cross(b).dot(normal), a.dot(b));
}

/// Twice the signed area that the triangle of the origin and an edge has in common with the disc about the
/// origin: of the edge's parts outside there are sectors, of that inside a triangle.
double part_of_edge(const Vec3& a, const Vec3& b, const Vec3& normal, double radius) {
  const Vec3 along = b - a;
  const double square = along.squaredNorm();
  if (square == 0) return 0;
  const double nearest = -a.dot(along) / square;
  const double half = radius * radius / square - (a + nearest * along).squaredNorm() / square;
  if (half <= 0) return sector(a, b, normal, radius);
  const double enter = std::clamp(nearest - std::sqrt(half), 0.0, 1.0),
               leave = std::clamp(nearest + std::sqrt(half), 0.0, 1.0);
  const Vec3 p = a + enter * along, q = a + leave * along;
  return (enter > 0 ? sector(a, p, normal, radius) : 0) + p.cross(q).dot(normal) +
         (leave < 1 ? sector(q, b, normal, radius) : 0);
}

}  // namespace

double area_in_disc(const std::array<Vec3, 3>& corners, const Vec3& center, double radius) {
  const Vec3 a = corners[0] - center, b = corners[1] - center, c = corners[2] - center;
  const Vec3 whole = (b - a).cross(c - a);
  if (whole.norm() == 0) return 0;
  const Vec3 normal = whole.normalized();
  return (part_of_edge(a, b, normal, radius) + part_of_edge(b, c, normal, radius) +
          part_of_edge(c, a, normal, radius)) /
         2;
}

}  // namespace etendue
