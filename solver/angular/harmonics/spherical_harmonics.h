// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "base/angular_space.h"
#include "base/vec3.h"

namespace etendue {

/// Number of spherical harmonics up to this degree.
constexpr int harmonic_count(int degree) { return (degree + 1) * (degree + 1); }

/// The same in either space: 2 degree + 1 functions in the plane.
constexpr int harmonic_count(AngularSpace space, int degree) {
  return space == AngularSpace::sphere ? harmonic_count(degree) : 2 * degree + 1;
}

/// Real spherical harmonics up to `degree` at a unit direction, scaled so that the mean of Y^2 over the
/// sphere is 1 (Y_0 = 1). `values[l^2 + l + m]` is that of degree l and order m = -l … l; those of degree 1
/// are sqrt 3 times y, z, x.
void spherical_harmonics(const Vec3& direction, int degree, std::span<double> values);

/// Real harmonics of the circle at a unit direction with z = 0, scaled alike: values[2k] = sqrt 2 cos(k t)
/// and values[2k - 1] = sqrt 2 sin(k t); those of degree 1 are sqrt 2 times y, x.
void circular_harmonics(const Vec3& direction, int degree, std::span<double> values);

/// One of the two.
void harmonics(AngularSpace space, const Vec3& direction, int degree, std::span<double> values);

}  // namespace etendue
