// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <optional>
#include <string>

#include "app/case/case.h"
#include "app/case/keys/section.h"

namespace etendue {

/// What a temperature needs to become a radiance in each band.
struct ThermalContext {
  const Bands& bands;
  const std::optional<BandValues>& molar_ratio;  ///< Case::molar_ratio
  const Units& units;
  AngularSpace space;
};

/// Why a temperature cannot become a radiance, or which of the keys `others` is given beside it; empty
/// where all is well.
std::string temperature_problem(const Section& section, const ThermalContext& context,
                                std::initializer_list<const char*> others);

/// What a wall neither reflects nor transmits.
double absorptivity(const WallCase& wall, int band);

/// The temperature of a medium that emits by it; empty where it is absent or faulty.
std::optional<BandValues> read_medium_temperature(Section& section, const ThermalContext& context);

/// Sets the emission that follows from a medium's temperature, if it has one: absorption times the radiance
/// of a blackbody (Kirchhoff's law).
void set_thermal_emission(Section& section, const ThermalContext& context, MediumCase& medium);

/// Reads `emissivity` and `temperature` of a wall whose reflectances and transmittance are read: the diffuse
/// reflectance and the radiance that follow.
void read_thermal_wall(Section& section, const ThermalContext& context, WallCase& wall);

}  // namespace etendue
