// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "base/errors.h"
#include "solver/materials/media/coefficient.h"

namespace etendue {

/// A medium whose temperature T follows from its heat,
///
///     -div(k grad T) = s + sum over bands of sigma_a (phi - 4 pi I_b(T)),
///
/// with the fluence phi and the radiance I_b of a blackbody.
struct HeatMedium {
  Coefficient conductivity = 0;  ///< k [W/(m K)]; 0: radiation alone moves heat
  Coefficient source = 0;        ///< s [W/m^3]
  Origin origin = {};            ///< of the medium in the case
};

/// What conducts, and where temperatures are held.
struct HeatProblem {
  std::vector<std::optional<HeatMedium>>
      media;  ///< [region]; none: the temperature is given, or there is none
  /// [wall] temperature of the surface, which media that conduct have there [K]; none: no heat is conducted
  /// into it.
  std::vector<std::optional<Coefficient>> wall_temperatures;
  double start = 300;  ///< temperature that the iteration starts from [K]
};

}  // namespace etendue
