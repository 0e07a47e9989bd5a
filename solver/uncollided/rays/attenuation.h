// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>

namespace etendue {

/// Integrals along a path of length l through constant extinction s: of e^(-s x) and of x e^(-s x).
struct AttenuationIntegrals {
  double constant;  ///< E0 = (1 - e^(-s l)) / s
  double linear;    ///< E1 = (1 - (1 + s l) e^(-s l)) / s^2
};

inline AttenuationIntegrals attenuation_integrals(double extinction, double length) {
  const double t = extinction * length;
  // The closed form of E1 loses digits like 1/t^2; the series has an error below t^6/5000.
  if (t < 0.02)
    return {length * (1 - t / 2 * (1 - t / 3 * (1 - t / 4 * (1 - t / 5)))),
            length * length * (0.5 - t * (1. / 3 - t * (1. / 8 - t * (1. / 30 - t / 144))))};
  const double lost = -std::expm1(-t);
  return {lost / extinction, (lost - t * std::exp(-t)) / (extinction * extinction)};
}

/// Integral along such a path of 4 (x/l) (1 - x/l) e^(-s x), the quadratic that is one in its middle.
inline double attenuated_quadratic(double extinction, double length) {
  const double t = extinction * length;
  if (t > 1) return 4 * length * (t - 2 + (t + 2) * std::exp(-t)) / (t * t * t);
  // The closed form loses digits like 1/t^3: the sum of (-t)^k / (k! (k+2) (k+3)).
  double sum = 0, term = 1;
  for (int k = 0; k < 16; ++k) {
    sum += term / ((k + 2) * (k + 3));
    term *= -t / (k + 1);
  }
  return 4 * length * sum;
}

}  // namespace etendue
