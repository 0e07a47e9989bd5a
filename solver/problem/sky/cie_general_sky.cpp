// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/sky/cie_general_sky.h"

#include <array>
#include <cmath>
#include <numbers>

namespace etendue {

// The indicatrix is 1 + c (exp(d chi) - exp(d pi/2)) + e cos^2 chi.
SkyShape cie_general_sky(int type) {
  struct Row {
    double a, b, c, d, e;
  };
  static constexpr std::array<Row, cie_sky_types> rows = {{
      {4.0, -0.70, 0, -1.0, 0},
      {4.0, -0.70, 2, -1.5, 0.15},
      {1.1, -0.80, 0, -1.0, 0},
      {1.1, -0.80, 2, -1.5, 0.15},
      {0, -1.00, 0, -1.0, 0},
      {0, -1.00, 2, -1.5, 0.15},
      {0, -1.00, 5, -2.5, 0.30},
      {0, -1.00, 10, -3.0, 0.45},
      {-1.0, -0.55, 2, -1.5, 0.15},
      {-1.0, -0.55, 5, -2.5, 0.30},
      {-1.0, -0.55, 10, -3.0, 0.45},
      {-1.0, -0.32, 10, -3.0, 0.45},
      {-1.0, -0.32, 16, -3.0, 0.30},
      {-1.0, -0.15, 16, -3.0, 0.30},
      {-1.0, -0.15, 24, -2.8, 0.15},
  }};
  const Row& row = rows[static_cast<std::size_t>(type - 1)];
  return {row.a, row.b, row.c, row.d, row.e, 1 - row.c * std::exp(row.d * std::numbers::pi / 2)};
}

}  // namespace etendue
