// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/sky/sky_shape.h"

#include <cmath>

namespace etendue {

double SkyShape::radiance(double zenith_angle, double from_sun) const {
  const double up = std::cos(zenith_angle), towards_sun = std::cos(from_sun);
  // At the horizon the exponential is zero: b is negative there in all models.
  const double gradation = up > 0 ? 1 + a * std::exp(b / up) : 1;
  return gradation * (k + c * std::exp(d * from_sun) + e * towards_sun * towards_sun);
}

}  // namespace etendue
