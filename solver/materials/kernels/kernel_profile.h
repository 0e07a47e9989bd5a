// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/materials/kernels/leaf_canopy.h"

namespace etendue {

/// Scattering of light in one direction by leaves, flakes or a formula, as a phase function gives it: the
/// share of the scattered light that goes into a unit of solid angle at an angle of deflection, in the mean
/// over the azimuth about the direction. A matrix between ordinates has none.
class KernelProfile {
 public:
  KernelProfile(const DirectionalScattering& scattering, const Vec3& before);

  /// Returns whether there is anything to show: the direction is scattered, and not by a matrix.
  bool is_known() const { return scattered_ > 0; }
  /// [1/sr] at the cosine of the angle of deflection; 2 pi times its integral over cosines is 1.
  double operator()(double cosine) const;

 private:
  const DirectionalScattering& scattering_;
  Vec3 before_;
  LeafNormals normals_;   ///< of leaves
  double scattered_ = 0;  ///< out of the direction, for a density of 1
};

}  // namespace etendue
