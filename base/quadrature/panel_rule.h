// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <utility>

namespace etendue {

/// Integral of f from a to b: Gauss and Legendre's three points in each of `panels` equal parts, of order 6.
template <class Function>
double integral_by_panels(double a, double b, int panels, const Function& f) {
  // The root of 3/5.
  constexpr double off = 0.77459666924148337704;
  constexpr std::array<std::pair<double, double>, 3> rule{{{-off, 5. / 9}, {0, 8. / 9}, {off, 5. / 9}}};
  const double half = (b - a) / (2 * panels);
  double sum = 0;
  for (int panel = 0; panel < panels; ++panel)
    for (const auto& [node, weight] : rule) sum += weight * f(a + half * (2 * panel + 1 + node));
  return half * sum;
}

}  // namespace etendue
