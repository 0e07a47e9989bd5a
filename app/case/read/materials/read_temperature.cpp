// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/read_temperature.h"

#include <fmt/format.h>

#include <cmath>

#include "app/case/values/band_values.h"
#include "app/case/values/blackbody_values.h"
#include "app/case/values/medium_coefficients.h"
#include "app/case/values/mixture_values.h"
#include "app/case/values/value_algebra.h"

namespace etendue {
namespace {

/// Edges that are not one more than the bands were reported already.
bool has_faulty_edges(const Bands& bands) {
  return !bands.edges.empty() && bands.edges.size() != bands.names.size() + 1;
}

double number_of_band(const BandValues& values, int band) {
  return values.values.empty() ? 0 : std::get<double>(value_of(values, band));
}

}  // namespace

std::string temperature_problem(const Section& section, const ThermalContext& context,
                                std::initializer_list<const char*> others) {
  for (const char* other : others)
    if (section.has(other))
      return fmt::format("{} is given too, and both say what is emitted; use one of them", other);
  if (context.space == AngularSpace::plane)
    return "not in flatland (the radiance of a blackbody is that of space); use emission or radiance";
  if (context.units.length != "m" || context.units.power != "W")
    return fmt::format(
        "needs meters and watts (the case has {} and {}); write coordinates in meters (mesh.scale "
        "multiplies those of files) with units.length = \"m\", and units.power = \"W\"",
        context.units.length, context.units.power);
  if (context.bands.count() > 1 && context.bands.edges.empty() && context.bands.gas.gases.empty())
    return fmt::format(
        "needs the edges of the {} bands, which divide the power of a blackbody; add "
        "bands.edges [nm], or use one band",
        context.bands.count());
  return "";
}

double absorptivity(const WallCase& wall, int band) {
  return 1 - number_of_band(wall.diffuse, band) - number_of_band(wall.specular, band) -
         number_of_band(wall.transmittance, band);
}

namespace {

std::string emissivity_problem(const WallCase& wall, const BandValues& emissivity, bool has_diffuse,
                               const Bands& bands) {
  for (int band = 0; band < bands.count(); ++band) {
    const double given = number_of_band(emissivity, band), rest = absorptivity(wall, band);
    if (has_diffuse && std::abs(given - rest) > written_agreement)
      return fmt::format(
          "differs from 1 - diffuse - specular - transmittance = {:.6g} (Kirchhoff's law); leave "
          "diffuse or emissivity out",
          rest);
    if (given > rest + written_agreement)
      return fmt::format("emissivity + specular + transmittance = {:.6g}; use at most 1", 1 - rest + given);
  }
  return "";
}

/// Diffuse reflectance of a wall of which `emissivity` is given.
BandValues diffuse_rest(const WallCase& wall, const BandValues& emissivity, const Bands& bands) {
  BandValues diffuse;
  diffuse.origin = emissivity.origin;
  for (int band = 0; band < bands.count(); ++band)
    diffuse.values.emplace_back(std::max(0.0, absorptivity(wall, band) - number_of_band(emissivity, band)));
  return diffuse;
}

void read_emissivity(Section& section, const Bands& bands, WallCase& wall) {
  const std::optional<BandValues> emissivity = read_band_values(section, "emissivity", bands);
  if (!emissivity) return;
  if (!wall.glossy.empty() || wall.refractive_index != 1)
    return section.fault(
        "emissivity",
        "not beside glossy or refractive_index (such an emissivity depends on the direction; "
        "not in this version); leave it out");
  const bool has_diffuse = section.has("diffuse");
  const std::string problem = emissivity_problem(wall, *emissivity, has_diffuse, bands);
  if (!problem.empty()) return section.fault("emissivity", problem);
  if (!has_diffuse) wall.diffuse = diffuse_rest(wall, *emissivity, bands);
}

/// The key `temperature`, unless it cannot become a radiance or one of `emission_keys` says the same.
std::optional<BandValues> sound_temperature(Section& section, const ThermalContext& context,
                                            std::initializer_list<const char*> emission_keys) {
  std::optional<BandValues> temperature = read_place_value(section, "temperature");
  if (!temperature || has_faulty_edges(context.bands)) return std::nullopt;
  const std::string problem = temperature_problem(section, context, emission_keys);
  if (problem.empty()) return temperature;
  section.fault("temperature", problem);
  return std::nullopt;
}

/// Radiance of a blackbody in each band, in a refractive index.
BandValues blackbody_values(const BandValues& temperature, const ThermalContext& context,
                            double refractive_index) {
  Bands bands = context.bands;
  bands.refractive_index = refractive_index;
  const Bands whole{.edges = {}, .refractive_index = refractive_index};
  const Value& kelvin = temperature.values.front();
  BandValues radiance;
  radiance.origin = temperature.origin;
  for (int band = 0; band < bands.count(); ++band)
    radiance.values.push_back(context.molar_ratio
                                  ? product(blackbody_radiance(kelvin, whole, 0),
                                            bordbar_weight(band, context.molar_ratio->values.front(), kelvin))
                                  : blackbody_radiance(kelvin, bands, band));
  return radiance;
}

/// Values times a factor of their band.
template <class FactorOf>
BandValues times(BandValues values, FactorOf factor_of) {
  for (std::size_t band = 0; band < values.values.size(); ++band)
    values.values[band] = product(factor_of(static_cast<int>(band)), values.values[band]);
  return values;
}

}  // namespace

std::optional<BandValues> read_medium_temperature(Section& section, const ThermalContext& context) {
  return sound_temperature(section, context, {"emission", "power_density", "power"});
}

void set_thermal_emission(Section& section, const ThermalContext& context, MediumCase& medium) {
  if (!medium.temperature) return;
  medium.blackbody = blackbody_values(*medium.temperature, context, context.bands.refractive_index);
  medium.emission =
      times(*medium.blackbody, [&](int band) { return matter_values(medium, band).absorption; });
  if (depend_on_direction(medium.emission))
    section.fault("temperature",
                  "not where absorption depends on the direction (not in this version); use emission");
}

void read_thermal_wall(Section& section, const ThermalContext& context, WallCase& wall) {
  read_emissivity(section, context.bands, wall);
  wall.temperature = sound_temperature(section, context, {"radiance"});
  if (!wall.temperature) return;
  if (wall.refractive_index != 1) {
    wall.radiance = blackbody_values(*wall.temperature, context, 1);  // from behind, out of vacuum
    return;
  }
  if (!wall.glossy.empty())
    return section.fault("temperature",
                         "not beside glossy (its emissivity depends on the direction; not in this version); "
                         "use radiance");
  wall.radiance = times(blackbody_values(*wall.temperature, context, context.bands.refractive_index),
                        [&](int band) { return Value(absorptivity(wall, band)); });
}

}  // namespace etendue
