// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read_light_strength.h"

#include <fmt/format.h>

#include "app/case/band_values.h"
#include "app/case/lamp_flux.h"
#include "app/case/point_light.h"
#include "solver/problem/lamp_shape.h"

namespace etendue {
namespace {

/// Whether names and edges are there and fit: what is wrong with them is reported elsewhere.
bool are_sound(const Bands& bands) {
  return !bands.names.empty() && (bands.edges.empty() || bands.edges.size() == bands.names.size() + 1);
}

void set_flux(Section& section, const LightContext& context, double lumens, LightCase& light) {
  const std::optional<double> kelvin = section.number_if("color_temperature");
  if (kelvin && context.bands.edges.empty())
    return section.fault("color_temperature",
                         "divides the light among the bands by their wavelengths, which are not known; give "
                         "bands.edges");
  light.strength =
      power_of_flux(lumens, lamp_spectrum(context.bands, kelvin), context.bands, context.units.power);
}

}  // namespace

std::vector<double> band_numbers_if(Section& section, std::string_view name, const Bands& bands) {
  const std::optional<BandValues> values = read_band_values(section, name, bands);
  std::vector<double> numbers;
  for (int b = 0; values && b < bands.count(); ++b) numbers.push_back(std::get<double>(value_of(*values, b)));
  return numbers;
}

void read_lamp_power(Section& section, const LightContext& context, std::optional<double> candelas,
                     LightCase& light) {
  if (section.has("power")) {
    for (const char* key : {"luminous_flux", "color_temperature"})
      section.unused(key, "`power` is given for each band");
    light.strength = band_numbers_if(section, "power", context.bands);
    return;
  }
  const bool given = section.has("luminous_flux");
  if (!given && !candelas)
    return section.fault(
        fmt::format("a light of kind {} needs power or luminous_flux; add one of them", light.kind));
  const std::optional<double> lumens = section.number_if("luminous_flux");
  if ((given && !lumens) || !are_sound(context.bands)) return;
  const std::string reason = no_lumens_reason(context.bands, context.units.power);
  if (!reason.empty())
    return given ? section.fault("luminous_flux", reason)
                 : section.fault("distribution", "is a lamp file with candelas, and " + reason);
  light.keeps_intensity = !given;
  set_flux(section, context, given ? *lumens : *candelas * integral_of_lamp_shape(point_light(light)), light);
}

}  // namespace etendue
