// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/quadrature/gauss_legendre.h"

#include <cmath>
#include <numbers>

namespace etendue {
namespace {

struct LegendreValue {
  double value;
  double derivative;
};

/// P_n and its derivative by the three-term recurrence.
LegendreValue legendre(int degree, double x) {
  double previous = 1, current = x;
  for (int l = 2; l <= degree; ++l) {
    const double next = ((2 * l - 1) * x * current - (l - 1) * previous) / l;
    previous = current;
    current = next;
  }
  return {current, degree * (x * current - previous) / (x * x - 1)};
}

/// The root of P_n next to Tricomi's estimate cos(pi (i + 3/4) / (n + 1/2)), by Newton's method.
double legendre_root(int degree, int i) {
  constexpr int most_steps = 20;  // quadratic from an estimate within O(n^-3): 4 suffice
  double x = std::cos(std::numbers::pi * (i + 0.75) / (degree + 0.5));
  for (int step = 0; step < most_steps; ++step) {
    const LegendreValue p = legendre(degree, x);
    const double change = p.value / p.derivative;
    x -= change;
    if (std::abs(change) < 1e-16) break;
  }
  return x;
}

}  // namespace

GaussRule gauss_legendre(int count) {
  const std::size_t n = static_cast<std::size_t>(count);
  GaussRule rule{std::vector<double>(n), std::vector<double>(n)};
  for (int i = 0; 2 * i < count; ++i) {
    const bool middle = 2 * i + 1 == count;
    const double x = middle ? 0.0 : legendre_root(count, i);
    const double slope = count == 1 ? 1.0 : legendre(count, x).derivative;
    const double weight = 2 / ((1 - x * x) * slope * slope);
    const std::size_t low = static_cast<std::size_t>(i), high = n - 1 - low;
    rule.nodes[low] = -x;
    rule.nodes[high] = x;
    rule.weights[low] = rule.weights[high] = weight;
  }
  return rule;
}

}  // namespace etendue
