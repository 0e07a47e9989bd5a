// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// When a sum over a simplex is good enough, or has cost enough.
struct SimplexEffort {
  double tolerance = 1e-3;  ///< estimated error relative to the largest integral
  std::size_t most_points = 1000;
};

/// Integrals over a triangle or a tetrahedron, given by its three or four corners, of functions that are not
/// negative and may jump inside: rules of degree 2 (Keast 1986) on parts that are halved across their longest
/// edge, where the sum over both halves differs most from that over the whole. `function` adds its values
/// [count] at a point to what it is given.
std::vector<double> integrate_over_simplex(
    std::span<const Vec3> corners, std::size_t count,
    const std::function<void(const Vec3&, std::span<double>)>& function, const SimplexEffort& effort);

}  // namespace etendue
