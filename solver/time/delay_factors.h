// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <span>

namespace etendue {

/// One or several factors of light of a source, by its number among those of the lights, that has been under
/// way for a time.
struct DelayFactors {
  std::size_t groups = 1;  ///< such as rates
  std::size_t parts = 1;   ///< of each: 2 for complex factors
  /// Sets [group][part].
  std::function<void(std::size_t source, double time, std::span<double> factors)> set;

  std::size_t count() const { return groups * parts; }
  /// Bands of what has been multiplied by all factors are [group][band][part].
  std::size_t band_of(std::size_t factor, std::size_t band, std::size_t bands) const {
    return (factor / parts * bands + band) * parts + factor % parts;
  }
};

/// e^(-s t) for some rates s.
DelayFactors delay_factors(std::span<const std::complex<double>> rates);

}  // namespace etendue
