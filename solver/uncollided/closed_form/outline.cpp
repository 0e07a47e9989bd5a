// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/outline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

#include "base/clipped_polygon.h"
#include "solver/uncollided/closed_form/triangle.h"

namespace etendue {
namespace {

/// Sides that turn by less than this lie in one line.
constexpr double straight_sides = 1e-9;
/// Sides of an outline that turn back by more than this are not convex.
constexpr double turns_back = 1e-12;
/// Areas that differ by less are the same.
constexpr double same_area = 1e-9;

std::array<double, 6> key(const Side& side) {
  return {side.first.x(), side.first.y(), side.first.z(), side.second.x(), side.second.y(), side.second.z()};
}

bool in_line(const Side& a, const Side& b) {
  const Vec3 x = a.second - a.first, y = b.second - b.first;
  return x.cross(y).norm() < straight_sides * x.norm() * y.norm() && x.dot(y) > 0;
}

/// Joins sides that continue in one line.
void join(std::vector<Side>& sides) {
  for (std::size_t i = 0; i < sides.size();) {
    const auto next = std::find_if(sides.begin(), sides.end(), [&](const Side& side) {
      return side.first == sides[i].second && in_line(sides[i], side);
    });
    if (next == sides.end()) {
      ++i;
      continue;
    }
    sides[i].second = next->second;
    const auto place = static_cast<std::size_t>(next - sides.begin());
    sides.erase(next);
    i = place < i ? i - 1 : i;
  }
}

/// The corners that sides in one ring join; empty where there is none, or more than one.
std::vector<Vec3> ring_of(const std::vector<Side>& sides) {
  if (sides.empty()) return {};
  std::vector<Vec3> corners{sides.front().first};
  const Side* at = &sides.front();
  while (at->second != corners.front()) {
    corners.push_back(at->second);
    const auto goes_on = [&](const Side& side) { return side.first == corners.back(); };
    if (corners.size() > sides.size() || std::ranges::count_if(sides, goes_on) != 1) return {};
    at = &*std::ranges::find_if(sides, goes_on);
  }
  if (corners.size() != sides.size()) return {};
  return corners;
}

bool is_convex(const std::vector<Vec3>& corners, const Vec3& normal) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 &before = corners[i], &here = corners[(i + 1) % corners.size()],
               &after = corners[(i + 2) % corners.size()];
    const Vec3 in = here - before, out = after - here;
    if (normal.dot(in.cross(out)) < -turns_back * in.norm() * out.norm()) return false;
  }
  return true;
}

/// Returns whether the triangles about the first corner cover what others do, and lie as they do.
bool stand_for(const std::vector<Vec3>& corners, std::span<const Triangle> triangles) {
  const Vec3& first = corners[0];
  double whole = 0, size = 0, height = 0;
  const Vec3 normal = (corners[1] - first).cross(corners[2] - first).normalized();
  for (const Triangle& triangle : triangles) {
    whole += triangle_area(triangle);
    for (const Vec3& corner : triangle) {
      size = std::max(size, (corner - first).norm());
      height = std::max(height, std::abs(normal.dot(corner - first)));
    }
  }
  return height <= rounding_height * size && std::abs(polygon_area(corners) - whole) <= same_area * whole;
}

}  // namespace

std::vector<Side> single_sides(std::span<const std::array<Vec3, 3>> triangles) {
  std::map<std::array<double, 6>, Side> single;
  for (const std::array<Vec3, 3>& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Side side{t[i], t[(i + 1) % 3]};
      if (single.erase(key({side.second, side.first})) == 0) single.emplace(key(side), side);
    }
  std::vector<Side> sides;
  for (const auto& [corners, side] : single) sides.push_back(side);
  return sides;
}

std::vector<Side> outline(std::span<const std::array<Vec3, 3>> triangles) {
  std::vector<Side> sides = single_sides(triangles);
  join(sides);
  return sides;
}

std::vector<Vec3> convex_outline(std::span<const Triangle> triangles, const Vec3& normal) {
  std::vector<Vec3> corners = ring_of(outline(triangles));
  if (corners.size() < 3 || !is_convex(corners, normal) || !stand_for(corners, triangles)) return {};
  return corners;
}

double distance_to_side(const Vec3& point, const Vec3& first, const Vec3& second) {
  const Vec3 along = second - first;
  const double part = std::clamp(along.dot(point - first) / along.squaredNorm(), 0.0, 1.0);
  return (first + part * along - point).norm();
}

}  // namespace etendue
