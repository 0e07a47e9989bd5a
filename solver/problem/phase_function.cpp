// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/phase_function.h"

#include <cmath>
#include <cstdio>
#include <numbers>

namespace etendue {
namespace {

/// The asymmetry; 0 for an isotropic phase function, which is the case g = 0 of Henyey and Greenstein's.
double asymmetry_of(const PhaseFunction& phase) {
  const auto* function = std::get_if<PhaseHenyeyGreenstein>(&phase);
  return function ? function->asymmetry : 0;
}

}  // namespace

double phase_value(const PhaseFunction& phase, double mu) {
  const double g = asymmetry_of(phase);
  const double base = 1 + g * g - 2 * g * mu;
  return (1 - g * g) / (4 * std::numbers::pi * base * std::sqrt(base));
}

double phase_moment(const PhaseFunction& phase, int degree) {
  return degree == 0 ? 1 : std::pow(asymmetry_of(phase), degree);
}

double phase_asymmetry(const PhaseFunction& phase) { return asymmetry_of(phase); }

std::string phase_name(const PhaseFunction& phase) {
  if (std::holds_alternative<PhaseIsotropic>(phase)) return "isotropic";
  char text[64];
  std::snprintf(text, sizeof text, "henyey-greenstein, g = %g", asymmetry_of(phase));
  return text;
}

}  // namespace etendue
