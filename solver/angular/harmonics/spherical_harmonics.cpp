// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/angular/harmonics/spherical_harmonics.h"

#include <cassert>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace etendue {
namespace {

std::size_t at(int degree, int order) {
  const int index = degree * degree + degree + order;
  return static_cast<std::size_t>(index);
}

/// Factor of the step from degrees l-1 and l-2 to l at order m: Q_l = a_l (z Q_{l-1} - Q_{l-2} / a_{l-1}).
double step_factor(int l, int m) { return std::sqrt((4.0 * l * l - 1) / (double(l) * l - double(m) * m)); }

}  // namespace

// Y_lm = Q_lm(z) Re or Im (x + i y)^|m|, where Q_lm is the normalised associated Legendre function divided by
// (1 - z^2)^(m/2): the usual three-term recurrence in l, and no division at the poles.
void spherical_harmonics(const Vec3& direction, int degree, std::span<double> values) {
  assert(values.size() == static_cast<std::size_t>(harmonic_count(degree)));
  const std::complex<double> plane(direction.x(), direction.y());
  std::complex<double> power = 1;  // (x + i y)^m
  double diagonal = 1;             // Q_mm
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) {
      power *= plane;
      diagonal *= std::sqrt((2 * m + 1.0) / (m == 1 ? 1.0 : 2.0 * m));
    }
    double before = 0, q = diagonal;
    for (int l = m; l <= degree; ++l) {
      if (l > m) {
        const double back = l == m + 1 ? 0 : before / step_factor(l - 1, m);
        before = std::exchange(q, step_factor(l, m) * (direction.z() * q - back));
      }
      values[at(l, m)] = q * power.real();
      if (m > 0) values[at(l, -m)] = q * power.imag();
    }
  }
}

void circular_harmonics(const Vec3& direction, int degree, std::span<double> values) {
  assert(values.size() == static_cast<std::size_t>(harmonic_count(AngularSpace::plane, degree)));
  const std::complex<double> plane(direction.x(), direction.y());
  std::complex<double> power = std::numbers::sqrt2;
  values[0] = 1;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(degree); ++k) {
    power *= plane;
    values[2 * k - 1] = power.imag();
    values[2 * k] = power.real();
  }
}

void harmonics(AngularSpace space, const Vec3& direction, int degree, std::span<double> values) {
  (space == AngularSpace::sphere ? spherical_harmonics : circular_harmonics)(direction, degree, values);
}

}  // namespace etendue
