// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace etendue {

/// A value at a time, and how far the inversion of its transform may be off.
struct ValueInTime {
  double value = 0;
  double error = 0;
};

/// Inversion of Laplace transforms by a Fourier series whose remainder is a continued fraction (de Hoog,
/// Knight and Stokes 1982), (L3) to (L5) of docs/theory/time.md. The same 41 rates serve all times of a
/// decade: functions are known there to about 1e-6 of their largest values, jumps included but for times next
/// to them.
class LaplaceInversion {
 public:
  static constexpr std::size_t rate_count = 41;

  /// For times in (0.1, 1] of `latest`. Throws std::invalid_argument where that is not positive.
  explicit LaplaceInversion(double latest);

  /// Where transforms have to be known [1/time], in the first quadrant.
  const std::vector<std::complex<double>>& rates() const { return rates_; }
  /// The value at each time of the function that has these values at rates(), known to a relative error. The
  /// error of a value is the change by a quarter of the rates, with bounds of what the series repeats and of
  /// what the errors of the transform become. Throws std::invalid_argument where there are not as many values
  /// as rates.
  std::vector<ValueInTime> at(std::span<const double> times, std::span<const std::complex<double>> transform,
                              double relative_error = 0) const;

 private:
  double half_period_;
  std::vector<std::complex<double>> rates_;
};

/// Parts a list of times into runs that one inversion serves: [run] the latest time of each, the last first.
std::vector<double> latest_times(std::span<const double> times);

}  // namespace etendue
