// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/laplace_inversion.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace etendue {
namespace {

using Complex = std::complex<double>;

/// After twice the half period the series repeats its function, this much smaller: (L4).
constexpr double repeated_part = 1e-6;
/// Half periods by the latest time: towards the end of one rounding counts for most.
constexpr double half_periods = 1.25;
/// An inversion serves times down to this part of its latest.
constexpr double earliest_part = 0.1;

/// Coefficients of the continued fraction d_0 / (1 + d_1 z / (1 + d_2 z / ...)) of a power series with
/// 2 n + 1 terms, by the quotient-difference algorithm.
std::vector<Complex> continued_fraction(std::span<const Complex> series) {
  const std::size_t half = (series.size() - 1) / 2;
  std::vector<Complex> fraction(series.size());
  std::vector<Complex> difference(series.size(), 0), quotient(series.size() - 1);
  for (std::size_t i = 0; i + 1 < series.size(); ++i) quotient[i] = series[i + 1] / series[i];
  fraction[0] = series[0];
  for (std::size_t r = 1; r <= half; ++r) {
    fraction[2 * r - 1] = -quotient[0];
    const std::size_t count = 2 * (half - r) + 1;
    for (std::size_t i = 0; i < count; ++i) difference[i] = quotient[i + 1] - quotient[i] + difference[i + 1];
    fraction[2 * r] = -difference[0];
    for (std::size_t i = 0; i + 1 < count; ++i)
      quotient[i] = quotient[i + 1] * difference[i + 1] / difference[i];
  }
  // The fraction of a rational function, or of nothing, ends with a zero, and nothing is known behind it.
  const auto end = std::ranges::find_if(fraction, [](const Complex& coefficient) {
    return coefficient == 0.0 || !std::isfinite(std::abs(coefficient));
  });
  std::fill(end, fraction.end(), 0.0);
  return fraction;
}

Complex value_of(std::span<const Complex> fraction, Complex z) {
  Complex last_numerator = 0, numerator = fraction[0], last_denominator = 1, denominator = 1;
  for (std::size_t n = 1; n < fraction.size(); ++n) {
    const Complex step = fraction[n] * z;
    last_numerator = std::exchange(numerator, numerator + step * last_numerator);
    last_denominator = std::exchange(denominator, denominator + step * last_denominator);
  }
  return numerator / denominator;
}

/// (L3) with the first terms of the series.
class PartialInversion {
 public:
  PartialInversion(std::span<const Complex> transform, double growth, double half_period)
      : growth_(growth), half_period_(half_period) {
    std::vector<Complex> series(transform.begin(), transform.end());
    series[0] /= 2;
    fraction_ = continued_fraction(series);
  }

  double at(double time) const {
    const Complex z = std::polar(1.0, std::numbers::pi * time / half_period_);
    return std::exp(growth_ * time) / half_period_ * value_of(fraction_, z).real();
  }

 private:
  double growth_;
  double half_period_;
  std::vector<Complex> fraction_;
};

}  // namespace

LaplaceInversion::LaplaceInversion(double latest) : half_period_(half_periods * latest) {
  if (!(latest > 0)) throw std::invalid_argument("times have to be positive");
  const double growth = -std::log(repeated_part) / (2 * half_period_);
  for (std::size_t k = 0; k < rate_count; ++k)
    rates_.emplace_back(growth, static_cast<double>(k) * std::numbers::pi / half_period_);
}

std::vector<ValueInTime> LaplaceInversion::at(std::span<const double> times,
                                              std::span<const Complex> transform,
                                              double relative_error) const {
  if (transform.size() != rates_.size()) throw std::invalid_argument("a transform has a value for each rate");
  const double growth = rates_.front().real();
  const PartialInversion all(transform, growth, half_period_);
  const PartialInversion fewer(transform.first(rate_count - rate_count / 4), growth, half_period_);
  // What is repeated is about the largest value that such a transform allows at the latest time.
  const double at_start = std::abs(transform.front()) / half_period_;
  const double repeated = repeated_part * std::exp(growth * half_period_ / half_periods) * at_start;
  std::vector<ValueInTime> values;
  for (const double time : times) {
    const double value = all.at(time);
    const double size = std::exp(growth * time) * at_start;
    values.push_back({value, std::abs(value - fewer.at(time)) + repeated + relative_error * size});
  }
  return values;
}

std::vector<double> latest_times(std::span<const double> times) {
  std::vector<double> sorted(times.begin(), times.end());
  std::ranges::sort(sorted, std::greater());
  std::vector<double> latest;
  for (const double time : sorted)
    if (latest.empty() || time <= earliest_part * latest.back()) latest.push_back(time);
  return latest;
}

}  // namespace etendue
