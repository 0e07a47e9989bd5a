// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "base/vector_sums.h"
#include "solver/heat/heat_balance.h"

namespace etendue {

/// The highest of some temperatures by its magnitude, at least 1 K: of what is colder, changes are judged by
/// that.
inline double highest_temperature(std::span<const double> kelvin) {
  return std::max(largest_magnitude(kelvin), 1.0);
}

/// Temperatures that bring the heat of media into balance where light diffuses and all bands are one,
///
///     -div(k grad t) + w t - kappa F = gain,    -div(D grad F) + kappa F = w t,
///
/// with the change t of the temperature and F of the fluence, w = 4 pi sum of sigma_a dI_b/dT, and bands
/// weighted by what each sends out more by free paths (linear multifrequency-gray acceleration; Morel, Larsen
/// and Matzen 1985). Walls whose temperature follows emit more by what they gain, and see the light of
/// Marshak's condition. It is what preconditions the iteration for temperatures.
class GrayDiffusion {
 public:
  /// The arguments must outlive it.
  GrayDiffusion(const Problem& problem, const TemperatureSpace& space, const HeatBalance& balance);

  /// [unknown] Changes of the unknowns [K] for gains [W] at these temperatures.
  std::vector<double> changes(std::span<const double> temperature, const Blackbodies& blackbodies,
                              std::span<const double> gains) const;

 private:
  double least_emission(CellIndex cell) const;

  const Problem& problem_;
  const TemperatureSpace& space_;
  const HeatBalance& balance_;
  double longest_path_;  ///< size of the domain [m]
};

}  // namespace etendue
