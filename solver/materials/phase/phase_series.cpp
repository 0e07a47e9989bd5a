// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/phase_series.h"

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
Smallest smallest_value(const PhaseLegendre& phase, AngularSpace space) {
  const int steps = 20 * static_cast<int>(phase.moments.size());
  const auto value_at = [&](double mu) {
    return space == AngularSpace::sphere ? value_of(phase, mu) : value_in_plane(phase, mu);
  };
  Smallest smallest = {value_at(1), 1};
  for (int i = 1; i <= steps; ++i) {
    const double mu = std::cos(std::numbers::pi * i / steps);
    if (const double value = value_at(mu); value < smallest.value) smallest = {value, mu};
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

double value_in_plane(const PhaseLegendre& phase, double mu) {
  double before = mu, cosine = 1, sum = 0;  // cos((k-1) t) and cos(k t)
  for (std::size_t k = 0; k < phase.moments.size(); ++k) {
    sum += (k == 0 ? 1 : 2) * phase.moments[k] * cosine;
    const double next = 2 * mu * cosine - before;
    before = cosine;
    cosine = next;
  }
  return sum / full_range(AngularSpace::plane);
}

double moment_of(const PhaseLegendre& phase, int degree) {
  const std::size_t l = static_cast<std::size_t>(degree);
  return l < phase.moments.size() ? phase.moments[l] : 0;
}

std::string name_of(const PhaseLegendre& phase) {
  return fmt::format("legendre, degree {}, g = {:g}", phase.moments.size() - 1, moment_of(phase, 1));
}

std::string series_problem(const std::vector<double>& moments, AngularSpace space) {
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
  const Smallest smallest = smallest_value({moments}, space);
  if (smallest.value * full_range(space) < -tolerated_dip)
    return fmt::format(
        "the series is negative, {:.3g} per {} at mu = {:.3g} (light cannot be scattered less than not at "
        "all); use more coefficients or a smoother function",
        smallest.value, space == AngularSpace::sphere ? "sr" : "rad", smallest.mu);
  return {};
}

}  // namespace etendue
