// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/primitives/sheet_shape.h"

#include <fmt/format.h>

#include <algorithm>

#include <Eigen/Geometry>

#include "mesh/geometry/primitives/exact.h"
#include "mesh/geometry/primitives/primitive_checks.h"

namespace etendue {
namespace {

/// Distance from the plane, relative to the size, that is rounding.
constexpr double kFlat = 1e-9;

/// Twice the area times the normal (Newell's sum over the edges).
Vec3 turn_of(const std::vector<Vec3>& corners) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
  return sum;
}

int dropped_axis(const Vec3& normal) {
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return axis;
}

bool edges_cross(const std::vector<Vec3>& corners, int axis) {
  const auto flat = [&](std::size_t i) {
    const Vec3& p = corners[i % corners.size()];
    return Exact::Point_2(p[(axis + 1) % 3], p[(axis + 2) % 3]);
  };
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      const bool next = j == i + 1, last = i == 0 && j + 1 == corners.size();
      const Exact::Segment_2 one(flat(i), flat(i + 1)), other(flat(j), flat(j + 1));
      if (!next && !last && CGAL::do_intersect(one, other)) return true;
      // Neighbours share a corner; they must not lie on each other.
      if (next && (one.has_on(other.target()) || other.has_on(one.source()))) return true;
    }
  return false;
}

}  // namespace

Vec3 sheet_normal(const Sheet& sheet) { return turn_of(sheet.corners).normalized(); }

std::string sheet_fault(const Sheet& sheet) {
  if (sheet.corners.size() < 3) return "has fewer than three corners; use three or more";
  for (const Vec3& corner : sheet.corners)
    if (!corner.allFinite()) return "coordinates must be finite numbers";
  double size = 0;
  for (const Vec3& corner : sheet.corners) size = std::max(size, (corner - sheet.corners[0]).norm());
  const Vec3 turn = turn_of(sheet.corners);
  if (!(turn.norm() > kFlat * size * size)) return "has no area; use corners that span one";
  const Vec3 normal = turn.normalized();
  for (const Vec3& corner : sheet.corners)
    if (std::abs(normal.dot(corner - sheet.corners[0])) > kFlat * size)
      return fmt::format("is not flat ({} lies beside the plane); use several sheets", text_of(corner));
  if (edges_cross(sheet.corners, dropped_axis(normal)))
    return "has edges that cross or touch each other; give the corners in order around it";
  return {};
}

std::vector<Vec3> rectangle_corners(const Vec3& min, const Vec3& max) {
  int axis = 0;
  while (axis < 2 && min[axis] != max[axis]) ++axis;
  const int b = (axis + 1) % 3, c = (axis + 2) % 3;
  Vec3 second = min, fourth = min;
  second[b] = max[b];
  fourth[c] = max[c];
  return {min, second, max, fourth};
}

Fault sheet_is_nowhere(const Sheet& sheet) {
  return fault_at(
      sheet.origin, "",
      fmt::format("sheet \"{}\" from {} lies nowhere inside the domain (on the outside and in holes "
                  "it is nothing, and later sheets hide it); move it inside",
                  sheet.front, text_of(sheet.corners.front())));
}

}  // namespace etendue
