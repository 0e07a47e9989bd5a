// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/phase_models.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace etendue {
namespace {

using std::numbers::pi;

double henyey_greenstein(double g, double mu) {
  const double base = 1 + g * g - 2 * g * mu;
  return (1 - g * g) / (4 * pi * base * std::sqrt(base));
}

/// Of Cornette and Shanks's function over (1 + mu^2) times Henyey and Greenstein's.
double cornette_shanks_factor(double g) { return 3 / (2 * (2 + g * g)); }

}  // namespace

double value_of(const PhaseIsotropic&, double) { return 1 / (4 * pi); }

double moment_of(const PhaseIsotropic&, int degree) { return degree == 0 ? 1 : 0; }

std::string name_of(const PhaseIsotropic&) { return "isotropic"; }

double value_of(const PhaseRayleigh&, double mu) { return 3 * (1 + mu * mu) / (16 * pi); }

// 3/4 (1 + mu^2) = P_0 + P_2/2, and the factor of P_2 is 5 times its moment.
double moment_of(const PhaseRayleigh&, int degree) { return degree == 0 ? 1 : degree == 2 ? 0.1 : 0; }

std::string name_of(const PhaseRayleigh&) { return "rayleigh"; }

double value_of(const PhaseHenyeyGreenstein& phase, double mu) {
  return henyey_greenstein(phase.asymmetry, mu);
}

double moment_of(const PhaseHenyeyGreenstein& phase, int degree) { return std::pow(phase.asymmetry, degree); }

std::string name_of(const PhaseHenyeyGreenstein& phase) {
  return fmt::format("henyey-greenstein, g = {:g}", phase.asymmetry);
}

double value_of(const PhaseDoubleHenyeyGreenstein& phase, double mu) {
  return phase.weight * henyey_greenstein(phase.first, mu) +
         (1 - phase.weight) * henyey_greenstein(phase.second, mu);
}

double moment_of(const PhaseDoubleHenyeyGreenstein& phase, int degree) {
  return phase.weight * std::pow(phase.first, degree) + (1 - phase.weight) * std::pow(phase.second, degree);
}

std::string name_of(const PhaseDoubleHenyeyGreenstein& phase) {
  return fmt::format("double-henyey-greenstein, g1 = {:g}, g2 = {:g}, weight = {:g}", phase.first,
                     phase.second, phase.weight);
}

double value_of(const PhaseCornetteShanks& phase, double mu) {
  const double g = phase.parameter;
  return cornette_shanks_factor(g) * (1 + mu * mu) * henyey_greenstein(g, mu);
}

// mu P_l = ((l+1) P_{l+1} + l P_{l-1}) / (2l+1), twice, gives mu^2 P_l; the moments of Henyey and
// Greenstein's function are powers of g.
double moment_of(const PhaseCornetteShanks& phase, int degree) {
  const double g = phase.parameter, l = degree;
  double sum = std::pow(g, degree) * (1 + (l + 1) * (l + 1) / ((2 * l + 1) * (2 * l + 3)));
  sum += std::pow(g, degree + 2) * (l + 1) * (l + 2) / ((2 * l + 1) * (2 * l + 3));
  if (degree >= 1) sum += std::pow(g, degree) * l * l / ((2 * l + 1) * (2 * l - 1));
  if (degree >= 2) sum += std::pow(g, degree - 2) * l * (l - 1) / ((2 * l + 1) * (2 * l - 1));
  return cornette_shanks_factor(g) * sum;
}

std::string name_of(const PhaseCornetteShanks& phase) {
  return fmt::format("cornette-shanks, g = {:g}", phase.parameter);
}

}  // namespace etendue
