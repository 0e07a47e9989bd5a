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
std::string wall_problem(const Section& section, const ThermalContext& context, const WallCase& wall) {
  // What is behind a smooth surface may have a temperature beside that of the surface.
  const bool is_smooth = wall.refractive_index != 1;
  if (std::string problem = is_smooth ? temperature_problem(section, context, {})
                                      : temperature_problem(section, context, {"temperature", "radiance"});
      !problem.empty())
    return problem;
  if (is_smooth && wall.heat_flux)
    return "not at a wall with a refractive_index, which absorbs nothing; leave heat_flux out";
  if (is_smooth && !(wall.convection->heat_transfer_coefficient > 0))
    return "does nothing at a wall with a refractive_index, which absorbs nothing; give h above 0";
  bool absorbs = false, transmits = false;
  for (int band = 0; band < context.bands.count(); ++band) {
    absorbs = absorbs || absorptivity(wall, band) > 0;
    transmits = transmits || std::get<double>(value_of(wall.transmittance, band)) > 0;
  }
  if (!wall.glossy.empty() || transmits)
    return "not beside glossy or transmittance (not in this version); give a temperature";
  if (!absorbs && !(wall.convection && wall.convection->heat_transfer_coefficient > 0))
    return "the wall does not absorb, so its temperature does not follow from light; reflect less, or leave "
           "it "
           "out";
  return "";
}

Convection read_convection(Section section) { return {section.number("h"), section.number("ambient")}; }

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
  medium.conductivity = read_place_value(section, "conductivity", FormulaOf::place_and_temperature);
  medium.heat_capacity = read_place_value(section, "heat_capacity", FormulaOf::place_and_temperature);
  medium.initial_temperature = read_place_value(section, "initial_temperature");
  if (!medium.follows_from_heat()) return;
  medium.reradiates = !medium.conductivity && !medium.heat_capacity && is_one_gray_band(context.bands);
  std::string problem =
      temperature_problem(section, context, {"temperature", "emission", "power_density", "power"});
  if (problem.empty() && (depend_on_direction(medium.absorption) || depend_on_direction(medium.extinction)))
    problem = "not where absorption depends on the direction (not in this version); use emission";
  if (problem.empty() && medium.reradiates) problem = reradiation_problem(medium);
  if (!problem.empty())
    return section.fault(medium.conductivity  ? "conductivity"
                         : medium.heat_source ? "heat_source"
                                              : "heat_capacity",
                         problem);
  if (medium.reradiates)
    medium.emission = BandValues{{product(medium.heat_source->values.front(), 1 / (4 * std::numbers::pi))},
                                 medium.heat_source->origin};
}

void read_wall_heat(Section& section, const ThermalContext& context, bool beside_conductors, WallCase& wall) {
  wall.heat_capacity = read_place_value(section, "heat_capacity", FormulaOf::place_and_temperature);
  wall.initial_temperature = read_place_value(section, "initial_temperature");
  if (!section.has("heat_flux") && !section.has("convection"))
    return section.unused("heat_capacity",
                          "the wall's temperature does not follow from heat; give heat_flux (0: none) or "
                          "convection too");
  if (section.has("heat_flux")) wall.heat_flux = section.number("heat_flux");
  if (section.has("convection")) wall.convection = read_convection(section.section("convection"));
  const std::string problem = wall_problem(section, context, wall);
  if (!problem.empty()) return section.fault(section.has("heat_flux") ? "heat_flux" : "convection", problem);
  // What a gray wall absorbs it gives back, as if it reflected it.
  wall.reradiates = !wall.convection && !wall.heat_capacity && !section.has("in_time") &&
                    !beside_conductors && is_one_gray_band(context.bands);
  if (wall.reradiates)
    wall.radiance = BandValues{{*wall.heat_flux / std::numbers::pi}, section.origin("heat_flux")};
}

}  // namespace etendue
