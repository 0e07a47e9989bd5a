// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "mesh/base/vec3.h"

namespace etendue {

/// Number of spherical harmonics up to this degree.
constexpr int harmonic_count(int degree) { return (degree + 1) * (degree + 1); }

/// Real spherical harmonics up to `degree` at a unit direction, scaled so that the mean of Y^2 over the
/// sphere is 1 (Y_0 = 1). `values[l^2 + l + m]` is that of degree l and order m = -l … l; those of degree 1
/// are sqrt 3 times y, z, x.
void spherical_harmonics(const Vec3& direction, int degree, std::span<double> values);

}  // namespace etendue
