// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/surfaces/reflectance.h"

#include <cmath>
#include <numbers>

namespace etendue {

double Reflectance::width() const {
  const double peak = value(1, 1, 1);
  return peak > 0 ? std::sqrt(albedo(1) * std::numbers::inv_pi / peak) : 1;
}

}  // namespace etendue
