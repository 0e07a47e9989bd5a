// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/time/delay_factors.h"

#include <vector>

namespace etendue {

DelayFactors delay_factors(std::span<const std::complex<double>> rates) {
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
