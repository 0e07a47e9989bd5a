// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "base/errors.h"
#include "solver/heat/thermal_property.h"
#include "solver/materials/media/coefficient.h"

namespace etendue {

/// What a medium or wall whose temperature follows needs where that changes with time.
struct HeatInTime {
  ThermalProperty capacity = 0;             ///< c [J/(m^3 K)] of a medium, [J/(m^2 K)] of a wall
  std::optional<Coefficient> initial = {};  ///< temperature at t = 0 [K]; none: HeatProblem::start
  /// Part of its heat source or heat flux that it has at a time t > 0 [s]; none: all of it, always.
  std::function<double(double t)> factor = {};
};

/// A medium whose temperature T follows from its heat,
///
///     c dT/dt - div(k grad T) = s + sum over bands of sigma_a (phi - 4 pi I_b(T)),
///
/// with the fluence phi and the radiance I_b of a blackbody. What does not change with time has no c.
struct HeatMedium {
  ThermalProperty conductivity = 0;  ///< k [W/(m K)]; 0: radiation alone moves heat
  Coefficient source = 0;            ///< s [W/m^3]
  Origin origin = {};                ///< of the medium in the case
  HeatInTime in_time = {};
};

/// A wall whose temperature T follows from its heat: on each square meter it gains
///
///     q + h (T_a - T) + sum over bands of epsilon_b (H_b - pi I_b(T)) + what is conducted into it = c dT/dt,
///
/// with the irradiance H_b.
struct HeatWall {
  double heat_flux = 0;                  ///< q [W/m^2]
  double heat_transfer_coefficient = 0;  ///< h [W/(m^2 K)]
  double ambient = 0;                    ///< T_a of what flows along the wall [K]
  HeatInTime in_time = {};
  Origin origin = {};  ///< of the wall in the case
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
  bool changes_in_time = false;  ///< else heat capacities are of no use, and what is found is steady
};

}  // namespace etendue
