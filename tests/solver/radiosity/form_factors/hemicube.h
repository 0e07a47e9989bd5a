// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "solver/radiosity/form_factors/lambert.h"

namespace etendue {

/// Form factors of a point by projection on the half of a cube about it (Cohen and Greenberg 1985): what the
/// middle of each pixel sees first, times the pixel's own form factor.
class Hemicube {
 public:
  /// Pixels along an edge of the cube: even.
  explicit Hemicube(int pixels);

  /// Form factors of a small element to the groups that triangles belong to, of which it sees fronts only;
  /// `group_of` is [triangle], and is below `groups`. The cube is turned about the normal by an angle [rad].
  std::vector<double> factors(const Vec3& point, const Vec3& normal, double angle,
                              const std::vector<TriangleCorners>& triangles,
                              const std::vector<std::size_t>& group_of, std::size_t groups);

 private:
  void draw(std::size_t side, const std::array<Vec3, 3>& corners, std::size_t group);

  int pixels_;
  std::vector<std::vector<double>> weights_;      ///< [side][pixel] form factors of the pixels, of 1 in all
  std::vector<std::vector<double>> depths_;       ///< [side][pixel]
  std::vector<std::vector<std::size_t>> groups_;  ///< [side][pixel]
};

/// Means over the middles of parts of a surface of triangles: at least `parts` of about the same area, made
/// by halving triangles across their longest sides. The cube stands differently on each, so that what its
/// pixels miss on one the next one has.
std::vector<double> factors_by_hemicube(const std::vector<TriangleCorners>& from, int parts,
                                        Hemicube& hemicube, const std::vector<TriangleCorners>& triangles,
                                        const std::vector<std::size_t>& group_of, std::size_t groups);

}  // namespace etendue
