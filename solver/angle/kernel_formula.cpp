// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angle/kernel_formula.h"

#include <cmath>
#include <numbers>

#include "solver/angle/unit_rule.h"

namespace etendue {
namespace {

using std::numbers::pi;

constexpr int turns = 96, azimuths = 64;

}  // namespace

double outgoing_moment(const KernelFormula& kernel, const Vec3& before, int power) {
  // 1 - cosine = 2 t^2 = 2 sin^2(angle/2): half of the points within 60 degrees, and peaks become wide.
  static const GaussRule rule = unit_rule(turns);
  const Vec3 side = before.unitOrthogonal(), other = before.cross(side);
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double t = rule.nodes[i], turned = 2 * t * t, sine = 2 * t * std::sqrt(1 - t * t);
    double ring = 0;
    for (int j = 0; j < azimuths; ++j) {
      const double azimuth = 2 * pi * (j + 0.5) / azimuths;
      ring += kernel.at(
          before, (1 - turned) * before + sine * (std::cos(azimuth) * side + std::sin(azimuth) * other));
    }
    sum += rule.weights[i] * 4 * t * 2 * pi / azimuths * ring * std::pow(turned, power);
  }
  return sum;
}

double mean_scattering(const KernelFormula& kernel) {
  // The scattering coefficient is smooth in the direction: 8 x 16 of them suffice for its mean.
  const GaussRule rule = unit_rule(8);
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i)
    for (int j = 0; j < 16; ++j) {
      const double cosine = 2 * rule.nodes[i] - 1, sine = std::sqrt(1 - cosine * cosine);
      const double azimuth = 2 * pi * (j + 0.5) / 16;
      const Vec3 before(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine);
      sum += rule.weights[i] / 16 * outgoing_moment(kernel, before, 0);
    }
  return sum;
}

}  // namespace etendue
