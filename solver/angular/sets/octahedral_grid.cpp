// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/sets/octahedral_grid.h"

#include <cmath>
#include <cstdlib>

namespace etendue {

OctahedralGrid::OctahedralGrid(int divisions) : divisions_(divisions) {
  const auto side = static_cast<std::size_t>(2 * divisions + 1);
  numbers_.assign(side * side * 2, -1);
  for (int i = -divisions; i <= divisions; ++i)
    for (int j = -divisions; j <= divisions; ++j) {
      const int k = divisions - std::abs(i) - std::abs(j);
      for (int sign = 1; k >= 0 && sign >= (k == 0 ? 1 : -1); sign -= 2) {
        number(i, j, sign < 0) = static_cast<std::int32_t>(directions_.size());
        directions_.push_back(Vec3(i, j, sign * k).normalized());
      }
      if (k == 0) number(i, j, true) = number(i, j, false);
    }
}

// In the octant of the direction the face of the octahedron falls into triangles that point up, whose
// corners are floor + unit vectors, and triangles that point down, floor + (1, 1, 1) - unit vectors.
OctahedralGrid::Weights OctahedralGrid::weights(const Vec3& direction, int stride) const {
  const int n = divisions_ / stride;
  const Vec3 place = direction.cwiseAbs() * (n / direction.lpNorm<1>());
  std::array<int, 3> floor{};
  std::array<double, 3> rest{};
  int missing = n;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double value = place[static_cast<Eigen::Index>(axis)];
    floor[axis] = static_cast<int>(value);
    rest[axis] = value - floor[axis];
    missing -= floor[axis];
  }
  // A point of the grid itself, all three coordinates of which were rounded down.
  if (missing == 3)
    for (int& whole : floor) ++whole;
  const double length = place.norm();
  Weights found{};
  for (std::size_t v = 0; v < 3; ++v) {
    std::array<int, 3> corner = floor;
    double share = 1;
    if (missing == 1) {
      ++corner[v];
      share = rest[v];
    } else if (missing == 2) {
      for (std::size_t axis = 0; axis < 3; ++axis) corner[axis] += axis == v ? 0 : 1;
      share = 1 - rest[v];
    } else if (v > 0) {
      share = 0;
    }
    Vec3 point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double sign = std::signbit(direction[static_cast<Eigen::Index>(axis)]) ? -1 : 1;
      point[static_cast<Eigen::Index>(axis)] = sign * corner[axis];
    }
    found.point[v] = number(stride * static_cast<int>(point.x()), stride * static_cast<int>(point.y()),
                            std::signbit(point.z()));
    found.weight[v] = share * point.norm() / length;
  }
  return found;
}

}  // namespace etendue
