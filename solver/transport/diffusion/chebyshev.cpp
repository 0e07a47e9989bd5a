// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/diffusion/chebyshev.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace etendue {
namespace {

constexpr int measurements = 6;
/// Spectra are measured until residuals have fallen this far: beyond, rounding would be measured.
constexpr double measured_tolerance = 1e-8;
/// Bounds are approached from inside.
constexpr double margin_below = 1.1;
constexpr double margin_above = 1.05;

}  // namespace

std::vector<double> rough_vector(std::size_t size) {
  std::vector<double> x(size);
  for (std::size_t i = 0; i < size; ++i) x[i] = std::sin(static_cast<double>(i * i % 1013));
  return x;
}

SpectrumBounds measure_spectrum(const LinearMap& matrix, const LinearMap& preconditioner, std::size_t size,
                                int threads) {
  std::vector<double> x(size), spectrum;
  ConjugateGradientOptions options{measured_tolerance, measurements, threads};
  options.ritz_values = &spectrum;
  conjugate_gradients(matrix, preconditioner, rough_vector(size), x, options);
  const auto usable = [](double value) { return std::isfinite(value) && value > 0; };
  if (spectrum.empty() || !std::all_of(spectrum.begin(), spectrum.end(), usable))
    throw std::domain_error("the matrix of diffusion is not positive definite");
  return {spectrum.front() / margin_below, spectrum.back() * margin_above};
}

ChebyshevSteps::ChebyshevSteps(const SpectrumBounds& bounds)
    : center_((bounds.highest + bounds.lowest) / 2),
      radius_((bounds.highest - bounds.lowest) / 2),
      previous_(radius_ / center_) {}

ChebyshevSteps::Factors ChebyshevSteps::next() {
  if (std::exchange(first_, false)) return {0, 1 / center_};
  const double factor = 1 / (2 * center_ / radius_ - previous_);
  const double keep = factor * std::exchange(previous_, factor);
  return {keep, 2 * factor / radius_};
}

double chebyshev_steps_for(double accuracy, const SpectrumBounds& bounds) {
  const double ratio = bounds.highest / bounds.lowest;
  return std::ceil(std::acosh(1 / accuracy) / std::acosh((ratio + 1) / (ratio - 1)));
}

}  // namespace etendue
