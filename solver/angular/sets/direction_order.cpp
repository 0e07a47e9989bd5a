// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/sets/direction_order.h"

#include <Eigen/Core>
#include <algorithm>
#include <utility>

namespace etendue {
namespace {

using Vec2 = Eigen::Vector2d;

bool is_upper(const Vec3& d) {
  if (d.z() != 0) return d.z() > 0;
  return d.y() != 0 ? d.y() > 0 : d.x() > 0;
}

/// Place of a direction on the curve. The octahedron |x| + |y| + |z| = 1 seen from above is a square of four
/// right triangles, one for each octant. The Sierpinski curve halves a triangle at its right angle again and
/// again; it enters at one acute corner and leaves at the other, where the next octant's begins.
std::uint64_t place_on_curve(const Vec3& direction) {
  constexpr int halvings = 48;  // triangles of 2^-24: far finer than any set
  const Vec2 p = direction.head<2>() / direction.lpNorm<1>();
  const int octant = p.y() >= 0 ? (p.x() > 0 ? 0 : 1) : (p.x() < 0 ? 2 : 3);
  const Vec2 corners[5] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
  Vec2 enter = corners[octant], leave = corners[octant + 1], apex = Vec2::Zero();
  std::uint64_t place = static_cast<std::uint64_t>(octant);
  for (int i = 0; i < halvings; ++i) {
    const bool second = (p - leave).squaredNorm() < (p - enter).squaredNorm();
    place = 2 * place + (second ? 1 : 0);
    const Vec2 middle = (enter + leave) / 2;
    (second ? enter : leave) = apex;
    apex = middle;
  }
  return place;
}

}  // namespace

std::vector<std::int32_t> upper_directions_along_curve(std::span<const Vec3> directions) {
  std::vector<std::pair<std::uint64_t, std::int32_t>> places;
  for (std::size_t m = 0; m < directions.size(); ++m)
    if (is_upper(directions[m]))
      places.emplace_back(place_on_curve(directions[m]), static_cast<std::int32_t>(m));
  std::sort(places.begin(), places.end());
  std::vector<std::int32_t> order;
  order.reserve(places.size());
  for (const auto& [place, m] : places) order.push_back(m);
  return order;
}

}  // namespace etendue
