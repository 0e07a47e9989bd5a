// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/phase_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace etendue {
namespace {

constexpr double four_pi = 4 * std::numbers::pi;
constexpr double tolerated_dip = 1e-3;  // of the mean, 1/(4 pi)
constexpr double same_as_one = 1e-9;

/// The smallest value among many angles: several in each swing of the highest polynomial.
struct Smallest {
  double value;
  double mu;
};
Smallest smallest_value(const PhaseLegendre& phase) {
  const int steps = 20 * static_cast<int>(phase.moments.size());
  Smallest smallest = {value_of(phase, 1), 1};
  for (int i = 1; i <= steps; ++i) {
    const double mu = std::cos(std::numbers::pi * i / steps);
    if (const double value = value_of(phase, mu); value < smallest.value) smallest = {value, mu};
  }
  return smallest;
}

}  // namespace

double value_of(const PhaseLegendre& phase, double mu) {
  double before = 0, polynomial = 1, sum = 0;
  for (std::size_t i = 0; i < phase.moments.size(); ++i) {
    const double l = static_cast<double>(i);
    sum += (2 * l + 1) * phase.moments[i] * polynomial;
    const double next = ((2 * l + 1) * mu * polynomial - l * before) / (l + 1);
    before = polynomial;
    polynomial = next;
  }
  return sum / four_pi;
}

double moment_of(const PhaseLegendre& phase, int degree) {
  const std::size_t l = static_cast<std::size_t>(degree);
  return l < phase.moments.size() ? phase.moments[l] : 0;
}

std::string name_of(const PhaseLegendre& phase) {
  return fmt::format("legendre, degree {}, g = {:g}", phase.moments.size() - 1, moment_of(phase, 1));
}

std::string series_problem(const std::vector<double>& moments) {
  if (moments.empty() || std::abs(moments.front() - 1) > same_as_one)
    return "does not begin with 1 (chi_0, the integral of the phase function); use chi_0 = 1, chi_1 = g, "
           "chi_2 "
           "…, without factors 2l + 1";
  for (std::size_t l = 1; l < moments.size(); ++l)
    if (!(std::abs(moments[l]) < 1))
      return fmt::format(
          "chi_{} = {:g} belongs to no phase function (p is not negative); use moments between -1 and 1, "
          "without factors 2l + 1",
          l, moments[l]);
  const Smallest smallest = smallest_value({moments});
  if (smallest.value * four_pi < -tolerated_dip)
    return fmt::format(
        "the series is negative, {:.3g} per sr at mu = {:.3g} (light cannot be scattered less than not at "
        "all); use more coefficients or a smoother function",
        smallest.value, smallest.mu);
  return {};
}

}  // namespace etendue
