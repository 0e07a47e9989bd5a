// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/problem/temperature_curve.h"

namespace etendue {

/// One of the gray gases whose weighted sum absorbs as a mixture of gases does.
struct GrayGas {
  TemperatureCurve absorption;  ///< by the partial pressure of what absorbs in the mixture [1/(m atm)]
  TemperatureCurve weight;      ///< fraction of a blackbody's power
};

/// Gray gases in place of the spectrum of a mixture: a weighted sum of gray gases, or the points of a
/// k-distribution. Their weights add up to 1.
struct GrayGases {
  std::vector<GrayGas> gases;
  double lowest = 0, highest = 0;  ///< temperatures for which they are known [K]
};

/// The spectral bands, solved side by side.
struct Bands {
  std::vector<std::string> names = {"grey"};
  std::vector<double> edges;  ///< [nm], one more than names; may be empty
  GrayGases gas = {};         ///< one gas for each band, or none; then there are no edges

  /// Of all media, where they have temperatures: into them blackbodies send its square times as much.
  double refractive_index = 1;

  int count() const { return static_cast<int>(names.size()); }
};

}  // namespace etendue
