// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/materials/phase/mie_sphere.h"

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

using Complex = std::complex<double>;

/// Terms after which the series has converged to double precision (Wiscombe 1980).
int term_count(double x) { return static_cast<int>(std::ceil(x + 4.05 * std::cbrt(x) + 2)); }

/// Logarithmic derivatives D_n of psi_n at a complex argument, [n] from 0, by downward recurrence from 0
/// (Bohren and Huffman 1983, equation 4.89). It forgets its start only where n > |z|, and slowly at first: by
/// exp(-1.9 k^(3/2) / |z|^(1/2)) after k steps, which 8 |z|^(1/3) steps bring below rounding.
std::vector<Complex> logarithmic_derivatives(Complex z, int terms) {
  const int start = std::max(terms, static_cast<int>(std::abs(z) + 8 * std::cbrt(std::abs(z)))) + 16;
  std::vector<Complex> d(static_cast<std::size_t>(start) + 1, 0.0);
  for (int n = start; n > 0; --n) {
    const auto at = static_cast<std::size_t>(n);
    const Complex ratio = static_cast<double>(n) / z;
    d[at - 1] = ratio - 1.0 / (d[at] + ratio);
  }
  return d;
}

/// Riccati-Bessel functions psi_n(x) = x j_n(x), [n] from 0. Upwards they are stable as long as n < x, and
/// lose what small x has; ratios of neighbours taken downwards do not.
std::vector<double> riccati_bessel(double x, int terms) {
  std::vector<double> psi(static_cast<std::size_t>(terms) + 1);
  psi[0] = std::sin(x);
  if (x > 1) {
    double before = std::cos(x);
    for (std::size_t n = 1; n < psi.size(); ++n) {
      const double next = (2.0 * static_cast<double>(n) - 1) / x * psi[n - 1] - before;
      before = psi[n - 1];
      psi[n] = next;
    }
    return psi;
  }
  std::vector<double> ratio(psi.size() + 16, 0.0);  // psi_n / psi_(n-1)
  for (std::size_t n = ratio.size() - 1; n > 0; --n)
    ratio[n - 1] = 1 / ((2.0 * static_cast<double>(n) - 1) / x - ratio[n]);
  for (std::size_t n = 1; n < psi.size(); ++n) psi[n] = psi[n - 1] * ratio[n];
  return psi;
}

/// chi_n(x) = -x y_n(x), [n] from 0; stable upwards.
std::vector<double> riccati_neumann(double x, int terms) {
  std::vector<double> chi(static_cast<std::size_t>(terms) + 1);
  chi[0] = std::cos(x);
  double before = -std::sin(x);
  for (std::size_t n = 1; n < chi.size(); ++n) {
    const double next = (2.0 * static_cast<double>(n) - 1) / x * chi[n - 1] - before;
    before = chi[n - 1];
    chi[n] = next;
  }
  return chi;
}

}  // namespace

// a_n and b_n: Bohren and Huffman (1983), equation 4.88.
MieSphere::MieSphere(double x, Complex index) {
  const int terms = term_count(x);
  const std::vector<Complex> d = logarithmic_derivatives(index * x, terms);
  const std::vector<double> psi = riccati_bessel(x, terms), chi = riccati_neumann(x, terms);
  for (std::size_t n = 1; n <= static_cast<std::size_t>(terms); ++n) {
    const Complex xi(psi[n], -chi[n]), xi_before(psi[n - 1], -chi[n - 1]);
    const double order = static_cast<double>(n) / x;
    const Complex electric = d[n] / index + order, magnetic = d[n] * index + order;
    electric_.push_back((electric * psi[n] - psi[n - 1]) / (electric * xi - xi_before));
    magnetic_.push_back((magnetic * psi[n] - psi[n - 1]) / (magnetic * xi - xi_before));
  }
  sum_efficiencies(x);
}

// Bohren and Huffman (1983), equations 4.61, 4.62 and section 4.5.
void MieSphere::sum_efficiencies(double x) {
  double cosine = 0;
  for (std::size_t i = 0; i < electric_.size(); ++i) {
    const double n = static_cast<double>(i + 1);
    const Complex &a = electric_[i], &b = magnetic_[i];
    extinction_ += (2 * n + 1) * (a + b).real();
    scattering_ += (2 * n + 1) * (std::norm(a) + std::norm(b));
    cosine += (2 * n + 1) / (n * (n + 1)) * (a * std::conj(b)).real();
    if (i + 1 < electric_.size())
      cosine +=
          n * (n + 2) / (n + 1) * (a * std::conj(electric_[i + 1]) + b * std::conj(magnetic_[i + 1])).real();
  }
  asymmetry_ = 2 * cosine / scattering_;
  extinction_ *= 2 / (x * x);
  scattering_ *= 2 / (x * x);
}

// Bohren and Huffman (1983), equation 4.74, with pi_n and tau_n by 4.47.
double MieSphere::intensity(double mu) const {
  Complex perpendicular = 0, parallel = 0;  // S_1, S_2
  double before = 0, pi = 1;
  for (std::size_t i = 0; i < electric_.size(); ++i) {
    const double n = static_cast<double>(i + 1);
    const double tau = n * mu * pi - (n + 1) * before;
    const double factor = (2 * n + 1) / (n * (n + 1));
    perpendicular += factor * (electric_[i] * pi + magnetic_[i] * tau);
    parallel += factor * (electric_[i] * tau + magnetic_[i] * pi);
    const double next = ((2 * n + 1) * mu * pi - (n + 1) * before) / n;
    before = pi;
    pi = next;
  }
  return std::norm(perpendicular) + std::norm(parallel);
}

}  // namespace etendue
