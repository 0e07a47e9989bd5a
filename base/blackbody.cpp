// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/blackbody.h"

#include <cmath>
#include <numbers>

namespace etendue {
namespace {

constexpr double second_radiation_constant = 1.438776877e7;  // [nm K], h c/k (CODATA 2018)

/// Below it the power series needs fewer terms than that of exponentials.
constexpr double small_argument = 0.5;

/// Beyond it exp(-x) is 0.
constexpr double largest_argument = 700;

constexpr double pi4 = std::numbers::pi * std::numbers::pi * std::numbers::pi * std::numbers::pi;

}  // namespace

// F = 15/pi^4 int_x^inf t^3/(e^t - 1) dt, x = c2/(lambda T). For large x 1/(e^t - 1) is the sum of e^(-n t)
// (Chang and Rhee, Int. Comm. Heat Mass Transfer 11 (1984) 451); for small x t/(e^t - 1) is its series of
// Bernoulli's numbers.
double blackbody_fraction(double wavelength_temperature) {
  if (!(wavelength_temperature > 0)) return std::isnan(wavelength_temperature) ? wavelength_temperature : 0;
  const double x = second_radiation_constant / wavelength_temperature;
  if (x > largest_argument) return 0;
  if (x < small_argument) {
    const double x2 = x * x;
    const double rest =
        x2 * x *
        (1. / 3 - x / 8 +
         x2 * (1. / 60 + x2 * (-1. / 5040 + x2 * (1. / 272160 + x2 * (-1. / 13305600 + x2 / 622702080)))));
    return 1 - 15 / pi4 * rest;
  }
  double sum = 0;
  for (int n = 1;; ++n) {
    const double term =
        std::exp(-n * x) / n * (x * x * x + 3 * x * x / n + 6 * x / (n * n) + 6. / (n * n * n));
    sum += term;
    if (!(term > 1e-17 * sum)) return 15 / pi4 * sum;
  }
}

// dF/d(lambda T) = 15/pi^4 x^3/(e^x - 1) x^2/c2.
double blackbody_fraction_slope(double wavelength_temperature) {
  if (!(wavelength_temperature > 0)) return std::isnan(wavelength_temperature) ? wavelength_temperature : 0;
  const double x = second_radiation_constant / wavelength_temperature;
  if (x > largest_argument) return 0;
  return 15 / pi4 * std::pow(x, 5) / (std::expm1(x) * second_radiation_constant);
}

}  // namespace etendue
