// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/closed_form/exponential_integrals.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

namespace etendue {
namespace {

/// Up to here the power series of E_1, beyond it the continued fraction of E_2.
constexpr double border = 2.5;
constexpr std::size_t series_terms = 24;
constexpr int fraction_terms = 24;
/// Beyond that e^-x is no longer a normal number.
constexpr double thickest = 700;

/// Coefficients of (E_1(x) + gamma + log x) / x.
constexpr std::array<double, series_terms> series_coefficients() {
  std::array<double, series_terms> series_of_integral{};
  double factorial = 1;
  for (std::size_t k = 1; k <= series_terms; ++k) {
    factorial *= static_cast<double>(k);
    series_of_integral[k - 1] = (k % 2 == 1 ? 1 : -1) / (static_cast<double>(k) * factorial);
  }
  return series_of_integral;
}
constexpr std::array<double, series_terms> series_of_integral = series_coefficients();

/// The rest is below 1e-13.
std::size_t terms_up_to(double x) { return x < 0.2 ? 8 : x < 0.7 ? 13 : series_terms; }

/// E_1 where x is at most the border.
Eight first_by_series(const Eight& x) {
  const std::size_t terms = terms_up_to(x.maxCoeff());
  Eight sum = Eight::Constant(series_of_integral[terms - 1]);
  for (std::size_t k = terms - 1; k-- > 0;) sum = sum * x + series_of_integral[k];
  const Eight logarithm = x.max(std::numeric_limits<double>::min()).log();
  return x * sum - logarithm - std::numbers::egamma;
}

/// E_2 where x is not below the border.
Eight second_by_fraction(const Eight& x, const Eight& transmittance) {
  Eight n_before = Eight::Zero(), n = Eight::Ones(), d_before = Eight::Ones(), d = x + 2;
  for (int k = 1; k < fraction_terms; ++k) {
    const double part = k * (k + 1);
    const Eight shift = x + (2 + 2 * k);
    const Eight n_next = shift * n - part * n_before, d_next = shift * d - part * d_before;
    n_before = n;
    d_before = d;
    n = n_next;
    d = d_next;
  }
  return transmittance * n / d;
}

}  // namespace

ExponentialIntegrals exponential_integrals(const Eight& thickness) {
  const Eight x = thickness.min(thickest);
  const Eight transmittance = (-x).exp();
  ExponentialIntegrals integrals{Eight::Zero(), Eight::Zero(), Eight::Zero()};
  auto& [first, second, third] = integrals;
  if (x.minCoeff() <= border) {
    first = first_by_series(x.min(border));
    second = transmittance - x * first;
  }
  if (x.maxCoeff() > border) {
    const Eight thick = x.max(border);
    const Eight of_thick = second_by_fraction(thick, transmittance);
    first = (x > border).select((transmittance - of_thick) / thick, first);
    second = (x > border).select(of_thick, second);
  }
  third = (transmittance - x * second) / 2;
  return integrals;
}

}  // namespace etendue
