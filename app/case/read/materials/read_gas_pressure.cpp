// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/read_gas_pressure.h"

#include <fmt/format.h>

#include "app/case/values/band_values.h"
#include "app/case/values/value_algebra.h"

namespace etendue {
namespace {

std::string pressure_problem(const Section& section, const ThermalContext& context) {
  if (context.bands.wsgg.gases.empty()) return "needs gray gases; add bands.wsgg, or give absorption instead";
  if (context.units.length != "m")
    return fmt::format(
        "needs meters (the case has {}); write coordinates in meters with units.length = \"m\"",
        context.units.length);
  for (const char* other : {"extinction", "albedo"})
    if (section.has(other))
      return fmt::format("not beside {} (gases add to absorption); give absorption and scattering", other);
  return "";
}

}  // namespace

void read_gas_pressure(Section& section, const ThermalContext& context, MediumCase& medium) {
  const std::optional<BandValues> pressure = read_place_value(section, "gas_pressure");
  if (!pressure || context.bands.names.empty()) return;
  if (const std::string problem = pressure_problem(section, context); !problem.empty())
    return section.fault("gas_pressure", problem);
  BandValues absorption{{}, pressure->origin};
  for (int band = 0; band < context.bands.count(); ++band) {
    const double by_pressure = context.bands.wsgg.gases[static_cast<std::size_t>(band)].absorption;
    const Value gray = product(by_pressure, pressure->values.front());
    absorption.values.push_back(medium.absorption ? sum(value_of(*medium.absorption, band), gray) : gray);
  }
  medium.absorption = std::move(absorption);
}

}  // namespace etendue
