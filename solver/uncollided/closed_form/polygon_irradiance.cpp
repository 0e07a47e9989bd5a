// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/polygon_irradiance.h"

#include <cmath>
#include <vector>

namespace etendue {
namespace {

/// The corners of the part where n.x >= 0.
std::vector<Vec3> above_the_horizon(std::span<const Vec3> corners, const Vec3& normal) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3& here = corners[i];
    const Vec3& next = corners[(i + 1) % corners.size()];
    const double at_here = normal.dot(here), at_next = normal.dot(next);
    if (at_here >= 0) kept.push_back(here);
    if ((at_here > 0 && at_next < 0) || (at_here < 0 && at_next > 0))
      kept.emplace_back((at_here * next - at_next * here) / (at_here - at_next));
  }
  return kept;
}

}  // namespace

double polygon_irradiance(std::span<const Vec3> corners, const Vec3& normal) {
  const std::vector<Vec3> seen = above_the_horizon(corners, normal);
  double sum = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Vec3& a = seen[i];
    const Vec3& b = seen[(i + 1) % seen.size()];
    const Vec3 across = a.cross(b);
    const double sine = across.norm();
    // An edge that points at the origin spans no angle.
    if (sine > 0) sum += std::atan2(sine, a.dot(b)) * normal.dot(across) / sine;
  }
  return std::abs(sum) / 2;
}

double triangle_solid_angle(const std::array<Vec3, 3>& corners) {
  const Vec3 &p = corners[0], &q = corners[1], &r = corners[2];
  const double a = p.norm(), b = q.norm(), c = r.norm();
  const double below = a * b * c + p.dot(q) * c + q.dot(r) * a + r.dot(p) * b;
  return 2 * std::atan2(std::abs(p.dot(q.cross(r))), below);
}

}  // namespace etendue
