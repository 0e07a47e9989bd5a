// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <numbers>

namespace etendue {

/// Where directions lie: on the sphere, or (flatland) on the circle of directions in the plane z = const, for
/// problems that do not depend on z. Radiance is per steradian on the sphere and per radian on the circle.
enum class AngularSpace { sphere, plane };

/// Integral of 1 over all directions: 4 pi [sr] or 2 pi [rad].
constexpr double full_range(AngularSpace space) {
  return (space == AngularSpace::sphere ? 4 : 2) * std::numbers::pi;
}

/// Integral of |w.n| over the directions with w.n < 0, what a wall of unit radiance emits: pi or 2. In the
/// plane the normal n must lie in it.
constexpr double half_range(AngularSpace space) {
  return space == AngularSpace::sphere ? std::numbers::pi : 2;
}

/// Axes that directions can have a component along: integral of w w^T = full_range / dimension.
constexpr int dimension(AngularSpace space) { return space == AngularSpace::sphere ? 3 : 2; }

}  // namespace etendue
