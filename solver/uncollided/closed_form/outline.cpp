// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/outline.h"

#include <algorithm>
#include <cstddef>
#include <map>

namespace etendue {
namespace {

/// Sides that turn by less than this lie in one line.
constexpr double straight_sides = 1e-9;

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

}  // namespace

std::vector<Side> outline(std::span<const std::array<Vec3, 3>> triangles) {
  std::map<std::array<double, 6>, Side> single;
  for (const std::array<Vec3, 3>& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Side side{t[i], t[(i + 1) % 3]};
      if (single.erase(key({side.second, side.first})) == 0) single.emplace(key(side), side);
    }
  std::vector<Side> sides;
  for (const auto& [corners, side] : single) sides.push_back(side);
  join(sides);
  return sides;
}

double distance_to_side(const Vec3& point, const Vec3& first, const Vec3& second) {
  const Vec3 along = second - first;
  const double part = std::clamp(along.dot(point - first) / along.squaredNorm(), 0.0, 1.0);
  return (first + part * along - point).norm();
}

}  // namespace etendue
