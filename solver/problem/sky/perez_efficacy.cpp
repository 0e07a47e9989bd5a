// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/sky/perez_efficacy.h"

#include <array>
#include <cmath>

namespace etendue {

double diffuse_luminous_efficacy(const SkyConditions& conditions, double sun_zenith,
                                 double precipitable_water) {
  struct Row {
    double a, b, c, d;
  };
  static constexpr std::array<Row, clearness_bins> rows = {{
      {97.24, -0.46, 12.00, -8.91},
      {107.22, 1.15, 0.59, -3.95},
      {104.97, 2.96, -5.53, -8.77},
      {102.39, 5.59, -13.95, -13.90},
      {100.71, 5.94, -22.75, -23.74},
      {106.42, 3.83, -36.15, -28.83},
      {141.88, 1.90, -53.24, -14.03},
      {152.23, 0.35, -45.27, -7.98},
  }};
  const Row& row = rows[clearness_bin(conditions.clearness)];
  return row.a + row.b * precipitable_water + row.c * std::cos(sun_zenith) +
         row.d * std::log(conditions.brightness);
}

}  // namespace etendue
