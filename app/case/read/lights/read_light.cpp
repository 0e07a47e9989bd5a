// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/lights/read_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/case/keys/resolve_path.h"
#include "app/case/lamps/light_table.h"
#include "app/case/read/lights/read_daylight.h"
#include "app/case/read/lights/read_light_strength.h"
#include "app/case/values/in_time_value.h"

namespace etendue {
namespace {

/// The keys of a kind of light besides name, kind and uncollided; those that it needs first.
struct KindKeys {
  std::string_view name;
  LightKind kind;
  std::vector<std::string> needed;
  std::vector<std::string> optional;
};

const std::array<KindKeys, 8>& kind_keys() {
  static const std::array<KindKeys, 8> kinds = {{
      {"point",
       LightKind::point,
       {"position"},
       {"power", "luminous_flux", "color_temperature", "distribution", "direction", "along"}},
      {"spot",
       LightKind::spot,
       {"position", "direction", "angle"},
       {"power", "luminous_flux", "color_temperature", "falloff"}},
      {"sun",
       LightKind::sun,
       {},
       {"direction", "sun_position", "irradiance", "illuminance", "color_temperature", "walls"}},
      {"beam",
       LightKind::beam,
       {"position", "direction", "radius"},
       {"power", "luminous_flux", "color_temperature", "profile", "numerical_aperture", "walls"}},
      {"disc",
       LightKind::disc,
       {"position", "direction", "radius"},
       {"radiance", "luminance", "color_temperature"}},
      {"rectangle",
       LightKind::rectangle,
       {"position", "direction", "along", "size"},
       {"radiance", "luminance", "color_temperature"}},
      {"wall", LightKind::wall, {"walls"}, {"radiance", "luminance", "color_temperature"}},
      {"sky",
       LightKind::sky,
       {},
       {"radiance", "luminance", "irradiance", "illuminance", "color_temperature", "walls", "distribution",
        "direction", "along", "cie_type", "direct_normal_irradiance", "diffuse_horizontal_irradiance",
        "sun_position"}},
  }};
  return kinds;
}

void check_kind_keys(Section& section, const KindKeys& kind) {
  for (const std::string& key : kind.needed)
    if (!section.has(key)) section.fault(fmt::format("a light of kind {} needs {}; add it", kind.name, key));
  for (const KindKeys& other : kind_keys())
    for (const auto* keys : {&other.needed, &other.optional})
      for (const std::string& key : *keys)
        if (std::ranges::count(kind.needed, key) == 0 && std::ranges::count(kind.optional, key) == 0 &&
            section.find(key) != nullptr)
          section.unused(key, fmt::format("it is no key of the kind {}", kind.name));
}

std::optional<Vec3> unit_if(Section& section, std::string_view name) {
  std::optional<Vec3> vector = section.point_if(name);
  if (!vector) return {};
  if (vector->norm() > 0) return vector->normalized();
  section.fault(name, "has no direction; use a vector that is not zero");
  return {};
}

/// What 1 of the intensity of a file is [cd] as the lamp is tilted; empty where only its shape counts. A
/// factor that counts is noted.
std::optional<double> tilted_candelas(Section& section, const LightTable& table, LightCase& light) {
  if (!table.candelas || section.has("power") || section.has("luminous_flux")) return {};
  const double tilted = std::acos(std::clamp(-light.direction.z(), -1., 1.)) * 180 / std::numbers::pi;
  if (const std::optional<double> factor = table.tilt.factor_at(tilted)) {
    if (!table.tilt.angle.empty())
      light.note = fmt::format("TILT factor {:.4g} at {:.4g} degrees{}", *factor, tilted,
                               table.tilt.lies_across && tilted > 0
                                   ? ", whichever way the lamp, which lies across its luminaire, is turned"
                                   : "");
    return *table.candelas * *factor;
  }
  section.fault(
      "distribution",
      fmt::format("is tilted by {:.4g} degrees, and its TILT factors are from {:.4g} to {:.4g}; turn the "
                  "lamp, or give power or luminous_flux",
                  tilted, table.tilt.angle.front(), table.tilt.angle.back()));
  return {};
}

/// The shape of a lamp or a sky; what 1 of it is [cd], empty where that is not known.
std::optional<double> read_shape(Section& section, LightCase& light, const std::filesystem::path& folder) {
  if (const TomlNode* file = section.find("distribution")) {
    LightTable table = read_light_table(readable_path(*file, folder));
    light.angle = std::move(table.angle);
    light.intensity = std::move(table.intensity);
    light.plane = std::move(table.plane);
    light.type = table.type;
    return tilted_candelas(section, table, light);
  }
  const auto angle = section.number_if("angle");
  if (!angle) return {};
  const double falloff = section.number("falloff");
  if (falloff > *angle) {
    section.fault("falloff", "is wider than the cone; use at most `angle`");
    return {};
  }
  light.angle = {0, *angle - falloff, *angle};
  light.intensity = {1, 1, 0};
  if (falloff == 0) light.intensity.back() = 1;
  return {};
}

void read_size(Section& section, LightCase& light) {
  const TomlNode* size = section.find("size");
  if (size == nullptr) return;
  if (size->array().size() != 2) return section.fault("size", "needs two lengths; give [along, across]");
  light.size = {size->array()[0]->number(), size->array()[1]->number()};
}

LightCase read_light(Section& section, const LightContext& context) {
  LightCase light;
  light.origin = section.origin();
  light.name = section.text_if("name").value_or("");
  light.uncollided = read_uncollided(section);
  light.in_time = read_in_time(section, context.folder);
  const auto kind = std::ranges::find(kind_keys(), section.text_if("kind").value_or(""), &KindKeys::name);
  if (kind == kind_keys().end()) {
    // Nothing is said about the keys of a kind that is not known.
    for (const KindKeys& any : kind_keys())
      for (const auto* keys : {&any.needed, &any.optional})
        for (const std::string& key : *keys) section.find(key);
    return light;
  }
  light.kind = kind->kind;
  check_kind_keys(section, *kind);
  light.position = section.point_if("position").value_or(Vec3::Zero());
  light.direction = unit_if(section, "direction").value_or(-Vec3::UnitZ());
  light.along = unit_if(section, "along").value_or(Vec3::UnitX());
  for (const char* key : {"along", "direction"})
    if ((light.kind == LightKind::sky ||
         (light.kind == LightKind::point && key == std::string_view("along"))) &&
        section.has(key) && !section.has("distribution"))
      section.unused(key, "only a distribution is turned there");
  if (!section.has("along") && std::abs(light.direction.x()) > 0.9) light.along = Vec3::UnitY();
  if (section.has("along") && light.along.cross(light.direction).norm() < 1e-6)
    section.fault("along", "has the direction in which the light shines; use one across it");
  light.radius = section.number_if("radius").value_or(0);
  if (light.kind == LightKind::beam) light.gaussian = section.text("profile") == "gaussian";
  light.numerical_aperture = section.number_if("numerical_aperture").value_or(0);
  read_size(section, light);
  const std::optional<double> candelas = read_shape(section, light, context.folder);
  std::optional<double> illuminance;
  if (light.kind == LightKind::sun || light.kind == LightKind::sky)
    illuminance = read_daylight(section, light);
  if (light.kind == LightKind::point || light.kind == LightKind::spot || light.kind == LightKind::beam)
    read_lamp_power(section, context, candelas, light);
  else
    read_strength(section, context, illuminance, light);
  if (section.has("walls"))
    for (const std::string& wall : section.texts("walls")) light.walls.push_back(wall);
  return light;
}

}  // namespace

std::vector<LightCase> read_lights(Section& top, const LightContext& context) {
  std::vector<LightCase> lights;
  for (Section& section : top.list("light")) {
    LightCase light = read_light(section, context);
    if (std::ranges::count(lights, light.name, &LightCase::name) > 0 && !light.name.empty())
      section.fault("name", "another light has this name; give each its own");
    lights.push_back(std::move(light));
  }
  return lights;
}

Uncollided read_uncollided(Section& section) {
  const TomlNode& node = section.value("uncollided");
  if (const bool* value = std::get_if<bool>(&node.value)) return *value ? Uncollided::yes : Uncollided::no;
  return Uncollided::automatic;
}

std::optional<LightCase> read_beam(Section& wall, const std::string& name, const Bands& bands) {
  if (!wall.has("beam")) return {};
  Section section = wall.section("beam");
  LightCase beam;
  beam.origin = section.origin();
  beam.name = name + ".beam";
  beam.kind = LightKind::sun;
  beam.of_wall = true;
  beam.walls = {name};
  beam.direction = unit_if(section, "direction").value_or(-Vec3::UnitZ());
  beam.strength = IrradianceOfLight{band_numbers_if(section, "irradiance", bands)};
  return beam;
}

}  // namespace etendue
