// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/lights/read_light_strength.h"

#include <fmt/format.h>

#include "app/case/point_light.h"
#include "app/case/read/lights/lamp_flux.h"
#include "app/case/values/band_values.h"
#include "solver/observe/color/photometry.h"
#include "solver/problem/lights/lamp_shape.h"

namespace etendue {
namespace {

/// Whether names and edges are there and fit: what is wrong with them is reported elsewhere.
bool are_sound(const Bands& bands) {
  return !bands.names.empty() && (bands.edges.empty() || bands.edges.size() == bands.names.size() + 1);
}

/// [band] What has so many lumens, with the spectrum that the light says; empty where something is wrong.
std::vector<double> power_of_lumens(Section& section, const LightContext& context, double lumens) {
  const std::optional<double> kelvin = section.number_if("color_temperature");
  if (!kelvin || !context.bands.edges.empty())
    return power_of_flux(lumens, lamp_spectrum(context.bands, kelvin), context.bands, context.units.power);
  section.fault(
      "color_temperature",
      "divides the light among the bands by their wavelengths, which are not known; give bands.edges");
  return {};
}

/// A quantity of radiometry and its counterpart in photometry.
struct StrengthKeys {
  const char* radiometric;
  const char* photometric;
  LightStrength quantity;  ///< without values
};

std::vector<StrengthKeys> strength_keys(LightKind kind) {
  const StrengthKeys irradiance{"irradiance", "illuminance", IrradianceOfLight{}},
      radiance{"radiance", "luminance", RadianceOfLight{}};
  if (kind == LightKind::sun) return {irradiance};
  if (kind == LightKind::sky) return {radiance, irradiance};
  return {radiance};
}

/// Why lumens per square metre cannot be converted; empty where they can.
std::string no_lux_reason(const LightContext& context) {
  const std::string reason = no_lumens_reason(context.bands, context.units.power);
  return reason.empty() && !si_scale(context.units.length, context.units.power)
             ? fmt::format("needs units.length of m, cm, mm or km, not \"{}\"", context.units.length)
             : reason;
}

/// [band] Lumens per square metre in units of the case.
std::vector<double> divided_per_area(Section& section, const LightContext& context, double lux) {
  const SiScale scale = si_scale(context.units.length, context.units.power).value();
  return power_of_lumens(section, context, lux * scale.length * scale.length);
}

/// Per square metre, in units of the case.
std::vector<double> read_per_area(Section& section, const LightContext& context, const char* key) {
  const std::optional<double> value = section.number_if(key);
  if (!value || !are_sound(context.bands)) return {};
  const std::string reason = no_lux_reason(context);
  if (reason.empty()) return divided_per_area(section, context, *value);
  section.fault(key, reason);
  return {};
}

/// Strength of a sky of Perez by its diffuse irradiance [W/m^2], which is of all wavelengths together: as it
/// is in one band without wavelengths, else as `illuminance` [lx]. False where it is neither.
bool take_diffuse(Section& section, const LightContext& context, std::optional<double> illuminance,
                  LightCase& light) {
  const char* key = "diffuse_horizontal_irradiance";
  if (!section.has(key)) return false;
  const std::optional<double> diffuse = section.number_if(key);
  if (!diffuse || !are_sound(context.bands)) return true;  // was refused
  const std::optional<SiScale> scale = si_scale(context.units.length, context.units.power);
  light.strength = IrradianceOfLight{};
  if (scale && context.bands.count() == 1 && context.bands.edges.empty()) {
    light.strength = IrradianceOfLight{{*diffuse * scale->length * scale->length / scale->power}};
    section.unused("color_temperature", "there is one band");
    return true;
  }
  if (!no_lux_reason(context).empty()) return false;
  if (illuminance) light.strength = IrradianceOfLight{divided_per_area(section, context, *illuminance)};
  return true;
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
    light.strength = PowerOfLight{band_numbers_if(section, "power", context.bands)};
    return;
  }
  const bool given = section.has("luminous_flux");
  if (!given && !candelas)
    return section.fault(fmt::format("a light of kind {} needs power or luminous_flux; add one of them",
                                     section.text("kind")));
  const std::optional<double> lumens = section.number_if("luminous_flux");
  if ((given && !lumens) || !are_sound(context.bands)) return;
  const std::string reason = no_lumens_reason(context.bands, context.units.power);
  if (!reason.empty())
    return given ? section.fault("luminous_flux", reason)
                 : section.fault("distribution", "is a lamp file with candelas, and " + reason);
  light.keeps_intensity = !given;
  light.strength = PowerOfLight{power_of_lumens(
      section, context, given ? *lumens : *candelas * integral_of_lamp_shape(point_light(light)))};
}

void read_strength(Section& section, const LightContext& context, std::optional<double> illuminance,
                   LightCase& light) {
  std::string wanted, found;
  for (const StrengthKeys& keys : strength_keys(light.kind))
    for (const char* key : {keys.radiometric, keys.photometric}) {
      wanted += (wanted.empty() ? "" : " or ") + std::string(key);
      if (!section.has(key)) continue;
      if (!found.empty()) {
        section.unused(key, fmt::format("`{}` is given", found));
        continue;
      }
      found = key;
      const bool radiometric = key == keys.radiometric;
      light.strength = keys.quantity;
      std::visit(
          [&](auto& quantity) {
            quantity.values = radiometric ? band_numbers_if(section, key, context.bands)
                                          : read_per_area(section, context, key);
          },
          light.strength);
      if (radiometric) section.unused("color_temperature", fmt::format("`{}` is given for each band", key));
    }
  if (!found.empty() || (light.kind == LightKind::sky && take_diffuse(section, context, illuminance, light)))
    return;
  section.fault(fmt::format("a light of kind {} needs {}; add one of them", section.text("kind"), wanted));
}

}  // namespace etendue
