// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace etendue {

/// Light of a source that has been under way for a time.
struct PathTime {
  std::size_t source;  ///< number among those of the lights
  double time;         ///< mean [time]
  double spread;       ///< of times about it that are alike, from the first to the last [time]
};

/// One or several factors of light by its path.
struct DelayFactors {
  std::size_t groups = 1;  ///< such as rates
  std::size_t parts = 1;   ///< of each: 2 for complex factors
  /// Sets [group][part]. Called by several threads at a time.
  std::function<void(const PathTime& path, std::span<double> factors)> set;

  std::size_t count() const { return groups * parts; }
  /// Bands of what has been multiplied by all factors are [group][band][part].
  std::size_t band_of(std::size_t factor, std::size_t band, std::size_t bands) const {
    return (factor / parts * bands + band) * parts + factor % parts;
  }
};

/// e^(-s t) for some rates s.
inline DelayFactors delay_factors(std::span<const std::complex<double>> rates) {
  return {rates.size(), 2,
          [all = std::vector(rates.begin(), rates.end())](const PathTime& path, std::span<double> factors) {
            for (std::size_t r = 0; r < all.size(); ++r) {
              const std::complex<double> factor = std::exp(-all[r] * path.time);
              factors[2 * r] = factor.real();
              factors[2 * r + 1] = factor.imag();
            }
          }};
}

}  // namespace etendue
