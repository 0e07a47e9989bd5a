// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/read_heat_balance.h"

#include <fmt/format.h>

#include <initializer_list>
#include <numbers>

#include "app/case/values/band_values.h"
#include "app/case/values/medium_coefficients.h"
#include "app/case/values/value_algebra.h"

namespace etendue {
namespace {

bool is_one_gray_band(const Bands& bands) { return bands.count() == 1 && bands.edges.empty(); }

/// Why the temperature of a wall cannot follow from its heat; empty where it can.
std::string wall_problem(const Section& section, const ThermalContext& context,
                         std::initializer_list<const char*> others) {
  if (std::string problem = temperature_problem(section, context, others); !problem.empty()) return problem;
  if (!is_one_gray_band(context.bands))
    return "needs one gray band without bands.edges (several bands are not in this version); give a "
           "temperature";
  return "";
}

/// Why a medium with these coefficients cannot reradiate; empty where it can.
std::string reradiation_problem(const MediumCase& medium) {
  const MatterValues values = matter_values(medium, 0);
  if (is_number(values.absorption) && std::get<double>(values.absorption) == 0)
    return "the medium does not absorb, so it has no temperature; give absorption, or leave heat_source out";
  const bool turns = !medium.phase.empty() && !std::holds_alternative<PhaseIsotropic>(medium.phase.front());
  if (turns && !(is_number(values.absorption) && is_number(values.scattering)))
    return "not where light scatters otherwise than isotropically and absorption or scattering is a formula "
           "(not "
           "in this version); use numbers";
  return "";
}

}  // namespace

void read_heat_source(Section& section, const ThermalContext& context, MediumCase& medium) {
  medium.heat_source = read_place_value(section, "heat_source");
  medium.conductivity = read_place_value(section, "conductivity");
  if (!medium.heat_source && !medium.conductivity) return;
  medium.reradiates = !medium.conductivity && is_one_gray_band(context.bands);
  std::string problem =
      temperature_problem(section, context, {"temperature", "emission", "power_density", "power"});
  if (problem.empty() && (depend_on_direction(medium.absorption) || depend_on_direction(medium.extinction)))
    problem = "not where absorption depends on the direction (not in this version); use emission";
  if (problem.empty() && medium.reradiates) problem = reradiation_problem(medium);
  if (!problem.empty()) return section.fault(medium.conductivity ? "conductivity" : "heat_source", problem);
  if (medium.reradiates)
    medium.emission = BandValues{{product(medium.heat_source->values.front(), 1 / (4 * std::numbers::pi))},
                                 medium.heat_source->origin};
}

void read_heat_flux(Section& section, const ThermalContext& context, WallCase& wall) {
  if (!section.has("heat_flux")) return;
  const double flux = section.number("heat_flux");
  std::string problem = wall_problem(section, context, {"temperature", "radiance"});
  const bool transmits = std::get<double>(value_of(wall.transmittance, 0)) > 0;
  if (problem.empty() && (!wall.glossy.empty() || wall.refractive_index != 1 || transmits))
    problem =
        "not beside glossy, refractive_index or transmittance (not in this version); give a temperature";
  if (problem.empty() && absorptivity(wall, 0) <= 0)
    problem = "the wall does not absorb, so it has no temperature; leave heat_flux out, or reflect less";
  if (!problem.empty()) return section.fault("heat_flux", problem);
  wall.heat_flux = flux;
  wall.radiance = BandValues{{flux / std::numbers::pi}, section.origin("heat_flux")};
}

}  // namespace etendue
