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

/// A wall whose temperature T follows from its heat: on each square meter it gains
///
///     q + h (T_a - T) + sum over bands of epsilon_b (H_b - pi I_b(T)) + what is conducted into it = 0,
///
/// with the irradiance H_b.
struct HeatWall {
  double heat_flux = 0;                  ///< q [W/m^2]
  double heat_transfer_coefficient = 0;  ///< h [W/(m^2 K)]
  double ambient = 0;                    ///< T_a of what flows along the wall [K]
};

/// What conducts, and where temperatures are held.
struct HeatProblem {
  std::vector<std::optional<HeatMedium>>
      media;  ///< [region]; none: the temperature is given, or there is none
  /// [wall] temperature of the surface, which media that conduct have there [K]; none: it follows, or no heat
  /// is conducted into it.
  std::vector<std::optional<Coefficient>> wall_temperatures;
  std::vector<std::optional<HeatWall>> walls;  ///< [wall]; none: the temperature is given, or there is none
  double start = 300;                          ///< temperature that the iteration starts from [K]
};

}  // namespace etendue
