// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/lights/side_light.h"

#include <algorithm>
#include <cmath>

#include "solver/angle/gauss_legendre.h"
#include "solver/lights/exponential_integrals.h"

namespace etendue {
namespace {

/// Longest piece that eight points see to 1e-9.
constexpr double longest_piece = 1.5;

struct EightPointRule {
  Eight node, weight;
  EightPointRule() {
    const GaussRule rule = gauss_legendre(8);
    for (Eigen::Index i = 0; i < 8; ++i) {
      node[i] = rule.nodes[static_cast<std::size_t>(i)];
      weight[i] = rule.weights[static_cast<std::size_t>(i)];
    }
  }
};

}  // namespace

FootIntegrals::FootIntegrals(double height, double extinction) {
  const ExponentialIntegrals of_height = exponential_integrals(Eight::Constant(extinction * height));
  second = of_height.second[0];
  third = of_height.third[0];
}

// With s = rho sinh(v) along the side, rho the distance of its line from the eye, r = rho cosh(v), and the
// integrands are analytic for |Im v| < pi / 2: df = d ds / (r^2 - h^2) has a pole where r = h, but there the
// differences vanish.
SideLight light_of_side(const SeenSide& side, double extinction, const FootIntegrals& below) {
  static const EightPointRule rule;
  const double h = side.height, near = std::hypot(h, side.distance);
  const double from = std::asinh(side.first / near), to = std::asinh(side.last / near);
  const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) / longest_piece)));
  const double half = (to - from) / (2 * pieces);
  SideLight light;
  for (int piece = 0; piece < pieces; ++piece) {
    const Eight growth = (from + half * (2 * piece + 1 + rule.node)).exp();
    const Eight r = near * (growth + growth.inverse()) / 2, s = near * (growth - growth.inverse()) / 2;
    const Eight length = half * rule.weight * r;
    const Eight angle = side.distance * length / (side.distance * side.distance + s * s);
    const Eight slope = h / r;
    const auto [second, third] = exponential_integrals(extinction * r);
    light.fluence += (angle * (below.second - slope * second)).sum();
    light.upward += (angle * (below.third - slope * slope * third)).sum();
    light.outward += (length * slope / r * third).sum();
  }
  return light;
}

}  // namespace etendue
