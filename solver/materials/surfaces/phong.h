// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/materials/surfaces/reflectance.h"

namespace etendue {

/// The lobe of Phong (1975) in the form of Lafortune and Willems (1994, eq. 7), which is reciprocal and
/// reflects no more than arrives:
///
///     f_r = r (n + 2)/(2 pi) cos^n a,    a the angle between o and the mirrored direction, 0 beyond 90
///     degrees.
///
/// Light that comes along the normal is reflected to the part r; of slant light the part of the lobe below
/// the surface is lost.
class Phong : public Reflectance {
 public:
  /// `reflectance` r from 0 to 1; `exponent` n of at least 0.
  Phong(double reflectance, double exponent);

  double value(double cos_in, double cos_out, double between) const override;
  ReflectedRay sample(double cos_in, double u, double v) const override;

 private:
  double exact_albedo(double cos_in) const;

  double reflectance_, exponent_;
};

}  // namespace etendue
