// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/read_gas_pressure.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/case/values/band_values.h"
#include "app/case/values/curve_value.h"
#include "app/case/values/mixture_values.h"
#include "app/case/values/value_algebra.h"

namespace etendue {
namespace {

bool absorb_alike_at_all_temperatures(const GrayGases& mixture) {
  return std::ranges::all_of(mixture.gases, [](const GrayGas& gas) { return gas.absorption.is_constant(); });
}

std::string pressure_problem(const Section& section, const ThermalContext& context) {
  if (context.bands.gas.gases.empty())
    return "needs gray gases; add bands.wsgg or bands.k_distribution, or give absorption instead";
  if (!section.has("temperature") && !absorb_alike_at_all_temperatures(context.bands.gas))
    return "the gases of bands.k_distribution absorb by the temperature, which is not given here; add "
           "temperature (one that follows from heat needs a file with the same absorption at all "
           "temperatures)";
  if (context.units.length != "m")
    return fmt::format(
        "needs meters (the case has {}); write coordinates in meters with units.length = \"m\"",
        context.units.length);
  for (const char* other : {"extinction", "albedo"})
    if (section.has(other))
      return fmt::format("not beside {} (gases add to absorption); give absorption and scattering", other);
  return "";
}

/// Absorption of the gas of a band by the pressure [1/(m atm)].
Value absorption_by_pressure(const MediumCase& medium, const ThermalContext& context, int band) {
  if (context.molar_ratio) return bordbar_absorption(band, context.molar_ratio->values.front());
  const Value kelvin = medium.temperature ? medium.temperature->values.front() : Value(0.0);
  return curve_value(context.bands.gas.gases[static_cast<std::size_t>(band)].absorption, kelvin);
}

}  // namespace

void read_gas_pressure(Section& section, const ThermalContext& context, MediumCase& medium) {
  const std::optional<BandValues> pressure = read_place_value(section, "gas_pressure");
  if (!pressure || context.bands.names.empty()) return;
  if (const std::string problem = pressure_problem(section, context); !problem.empty())
    return section.fault("gas_pressure", problem);
  if (section.has("temperature") && !medium.temperature) return;  // a faulty one
  BandValues absorption{{}, pressure->origin};
  for (int band = 0; band < context.bands.count(); ++band) {
    const Value gray = product(absorption_by_pressure(medium, context, band), pressure->values.front());
    absorption.values.push_back(medium.absorption ? sum(value_of(*medium.absorption, band), gray) : gray);
  }
  medium.absorption = std::move(absorption);
  medium.gas_pressure = pressure;
}

}  // namespace etendue
