// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "app/case/case.h"
#include "app/case/keys/section.h"
#include "app/case/read/lights/read_light.h"

namespace etendue {

/// Reads the power of a point or a spot: from `power`, from `luminous_flux`, or, with neither of them, from
/// the candelas of its file. `candelas` is what 1 of its intensity is [cd].
void read_lamp_power(Section& section, const LightContext& context, std::optional<double> candelas,
                     LightCase& light);

/// Reads the radiance or irradiance of other kinds of light, in units of radiometry or photometry. Without
/// any a sky of Perez has the irradiance by which it is known, in one band without wavelengths, or
/// `illuminance` on a level plane [lx], in bands that the eye sees.
void read_strength(Section& section, const LightContext& context, std::optional<double> illuminance,
                   LightCase& light);

/// [band] Numbers of a key; empty where it is absent or faulty.
std::vector<double> band_numbers_if(Section& section, std::string_view name, const Bands& bands);

}  // namespace etendue
