// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// Unit directions at the points (i, j, k)/n of an octahedron, |i| + |j| + |k| = n, projected on the sphere,
/// and linear interpolation between them. The grid has all 48 symmetries of the cube.
class OctahedralGrid {
 public:
  /// `divisions` n of each edge of the octahedron, at least 1.
  explicit OctahedralGrid(int divisions);

  int divisions() const { return divisions_; }
  std::size_t size() const { return directions_.size(); }  ///< 4 n^2 + 2
  const Vec3& direction(std::size_t point) const { return directions_[point]; }

  /// Three points of the grid around a direction w and weights a_v >= 0 with
  ///
  ///     sum over v of a_v direction(v) = w,
  ///
  /// exactly, so that their sum exceeds 1 by the square of the distance between the points, in the order of
  /// magnitude.
  struct Weights {
    std::array<std::int32_t, 3> point;
    std::array<double, 3> weight;
  };
  /// With a stride, which has to divide n, only the points of the grid of n/stride divisions are taken.
  Weights weights(const Vec3& direction, int stride = 1) const;

 private:
  std::int32_t& number(int i, int j, bool below) {
    return numbers_[static_cast<std::size_t>(((i + divisions_) * (2 * divisions_ + 1) + j + divisions_) * 2 +
                                             (below ? 1 : 0))];
  }
  std::int32_t number(int i, int j, bool below) const {
    return const_cast<OctahedralGrid*>(this)->number(i, j, below);
  }

  int divisions_;
  std::vector<Vec3> directions_;
  std::vector<std::int32_t> numbers_;  ///< [i][j][k < 0], -1 outside of the octahedron
};

}  // namespace etendue
