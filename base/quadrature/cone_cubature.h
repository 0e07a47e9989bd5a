// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// Directions within an angle of an axis.
struct Cone {
  Vec3 axis = Vec3::UnitZ();  ///< unit
  double half_angle = 0;      ///< [rad], above 0, at most pi

  double solid_angle() const;            ///< [sr]
  double projected_solid_angle() const;  ///< of a cone up to pi/2: pi sin^2 [sr]
  bool holds(const Vec3& direction) const;
};

/// Writes the values of functions of a unit direction.
using ConeFunctions = std::function<void(const Vec3& direction, std::span<double> values)>;

struct ConeIntegrals {
  std::vector<double> values;  ///< integrals over the solid angle
  std::vector<double> errors;  ///< estimates; where edges cross the cone they may be too small, seldom by 3
  int directions = 0;          ///< that were looked into
};

/// Integrals of `count` functions over a cone by patches of polar angle and azimuth, each with the 17 points
/// of Genz and Malik (1980) of degree 7 and their embedded rule of degree 5. The patch of the largest error
/// is halved until the errors are below `relative` of the integrals or `most` directions have been taken.
/// Where `go_on` says no, the integrals are not complete.
ConeIntegrals integrate_over_cone(const Cone& cone, std::size_t count, const ConeFunctions& functions,
                                  double relative, int most, const std::function<bool()>& go_on = {});

}  // namespace etendue
