// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "base/quadrature/gauss_legendre.h"
#include "solver/uncollided/closed_form/exponential_integrals.h"

namespace etendue {

/// Eight points of a straight side as an eye sees them.
struct SidePoints {
  Eight distance;  ///< from the eye [length]
  Eight place;     ///< along the side, from its point nearest to the eye [length]
  Eight length;    ///< weights of an integral along the side [length]
};

/// Calls `use` with points of a side that runs from `first` to `last`, counted from the point of its line
/// nearest to the eye, which is `nearest` away (positive). With s = rho sinh(v) along the side, rho being
/// that distance, r = rho cosh(v), and what is smooth in r is analytic in v for |Im v| < pi / 2: eight points
/// of Gauss see a piece of 1.5 to 1e-9.
template <class Use>
void for_points_of_side(double nearest, double first, double last, const Use& use) {
  struct Rule {
    Eight node, weight;
    Rule() {
      const GaussRule gauss = gauss_legendre(8);
      for (Eigen::Index i = 0; i < 8; ++i) {
        node[i] = gauss.nodes[static_cast<std::size_t>(i)];
        weight[i] = gauss.weights[static_cast<std::size_t>(i)];
      }
    }
  };
  static const Rule rule;
  constexpr double longest_piece = 1.5;
  // Faster than that of the library, and as good for differences.
  const auto asinh = [](double x) { return std::copysign(std::log(std::abs(x) + std::sqrt(x * x + 1)), x); };
  const double from = asinh(first / nearest), to = asinh(last / nearest);
  const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) / longest_piece)));
  const double half = (to - from) / (2 * pieces);
  for (int piece = 0; piece < pieces; ++piece) {
    const Eight growth = (from + half * (2 * piece + 1 + rule.node)).exp();
    const Eight shrinkage = growth.inverse();
    const Eight distance = nearest * (growth + shrinkage) / 2;
    use(SidePoints{distance, nearest * (growth - shrinkage) / 2, half * rule.weight * distance});
  }
}

}  // namespace etendue
