// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace etendue {

/// One of the gray gases whose weighted sum absorbs as a mixture of gases does.
struct GrayGas {
  double absorption = 0;  ///< coefficient by the partial pressure of what absorbs in the mixture [1/(m atm)]
  std::vector<double> weight;  ///< fraction of a blackbody's power: polynomial of T [K], constant term first

  /// The fraction at a temperature [K].
  double weight_at(double kelvin) const {
    double sum = 0;
    for (auto term = weight.rbegin(); term != weight.rend(); ++term) sum = sum * kelvin + *term;
    return sum;
  }
};

/// Gray gases in place of the spectrum of a mixture, the clear gas first. Their weights add up to 1.
struct GrayGases {
  std::vector<GrayGas> gases;
  double lowest = 0, highest = 0;  ///< temperatures that the weights were fitted to [K]
};

/// The spectral bands, solved side by side.
struct Bands {
  std::vector<std::string> names = {"grey"};
  std::vector<double> edges;  ///< [nm], one more than names; may be empty
  GrayGases wsgg = {};        ///< one gas for each band, or none; then there are no edges

  /// Of all media, where they have temperatures: into them blackbodies send its square times as much.
  double refractive_index = 1;

  int count() const { return static_cast<int>(names.size()); }
};

}  // namespace etendue
