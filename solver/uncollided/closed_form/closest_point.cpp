// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/closest_point.h"

#include <algorithm>

namespace etendue {
namespace {

Vec3 closest_on_side(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length = along.squaredNorm();
  const double part = length > 0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0;
  return a + part * along;
}

}  // namespace

Vec3 closest_in_triangle(const Vec3& point, const std::array<Vec3, 3>& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  Vec3 best = t[0];
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a = t[i], &b = t[(i + 1) % 3];
    inside = inside && normal.dot((b - a).cross(point - a)) >= 0;
    const Vec3 on_side = closest_on_side(point, a, b);
    if ((on_side - point).squaredNorm() < (best - point).squaredNorm()) best = on_side;
  }
  if (inside && normal.squaredNorm() > 0)
    return point - normal.dot(point - t[0]) / normal.squaredNorm() * normal;
  return best;
}

Vec3 closest_in_tetrahedron(const Vec3& point, const std::array<Vec3, 4>& corners) {
  Vec3 best = corners[0];
  bool inside = true;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::array<Vec3, 3> face = {corners[(k + 1) % 4], corners[(k + 2) % 4], corners[(k + 3) % 4]};
    const Vec3 normal = (face[1] - face[0]).cross(face[2] - face[0]);
    inside = inside && normal.dot(point - face[0]) * normal.dot(corners[k] - face[0]) >= 0;
    const Vec3 on_face = closest_in_triangle(point, face);
    if ((on_face - point).squaredNorm() < (best - point).squaredNorm()) best = on_face;
  }
  return inside ? point : best;
}

}  // namespace etendue
