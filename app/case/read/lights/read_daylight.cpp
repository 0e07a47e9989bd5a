// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/lights/read_daylight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/case/read/lights/read_sun.h"
#include "base/degree.h"
#include "solver/problem/sky/cie_general_sky.h"
#include "solver/problem/sky/perez_efficacy.h"
#include "solver/problem/sky/perez_sky.h"

namespace etendue {
namespace {

using std::numbers::pi;

// Steps of the table that a sky becomes: its parts are about ten degrees wide.
constexpr int angle_steps = 45, azimuth_steps = 120;

/// The table of a sky whose zenith is 1. False where the model is negative or infinite somewhere.
bool fill_table(const SkyShape& shape, const SunPlace& sun, LightCase& light) {
  const Vec3 up = Vec3::UnitZ(), west = up.cross(sun.north);
  light.direction = -up;
  light.along = sun.north;
  light.type = PhotometricType::c;
  for (int i = 0; i <= angle_steps; ++i) light.angle.push_back(90. * i / angle_steps);
  for (int j = 0; j <= azimuth_steps; ++j) light.plane.push_back(360. * j / azimuth_steps);
  const double zenith = shape.radiance(0, std::acos(std::clamp(sun.to_sun.z(), -1., 1.)));
  for (const double azimuth : light.plane)
    for (const double angle : light.angle) {
      const double theta = angle * one_degree, phi = azimuth * one_degree;
      const Vec3 at =
          std::cos(theta) * up + std::sin(theta) * (std::cos(phi) * sun.north + std::sin(phi) * west);
      const double from_sun = std::acos(std::clamp(at.dot(sun.to_sun), -1., 1.));
      light.intensity.push_back(shape.radiance(angle < 90 ? theta : pi / 2, from_sun) / zenith);
    }
  return zenith > 0 && std::ranges::all_of(light.intensity,
                                           [](double value) { return value >= 0 && std::isfinite(value); });
}

/// Whether the radiance of a type depends on where the sun stands.
bool depends_on_sun(const SkyShape& sky) { return sky.c != 0 || sky.e != 0; }

void read_cie_sky(Section& section, int type, const std::optional<SunPlace>& sun, LightCase& light) {
  for (const char* key : {"direct_normal_irradiance", "diffuse_horizontal_irradiance"})
    section.unused(key, "`cie_type` is given");
  const SkyShape sky = cie_general_sky(type);
  if (depends_on_sun(sky) && !sun) {
    if (!section.has("sun_position"))
      section.fault("cie_type", "is brighter towards the sun; add sun_position");
    return;
  }
  fill_table(sky, sun.value_or(SunPlace{}), light);
  light.note =
      fmt::format("CIE standard general sky {}", type) + (light.note.empty() ? "" : ", ") + light.note;
}

std::optional<double> read_perez_sky(Section& section, const std::optional<SunPlace>& sun, LightCase& light) {
  const auto direct = section.number_if("direct_normal_irradiance"),
             diffuse = section.number_if("diffuse_horizontal_irradiance");
  for (const char* key : {"direct_normal_irradiance", "diffuse_horizontal_irradiance"})
    if (!section.has(key)) section.fault(fmt::format("a sky of Perez needs two irradiances; add {}", key));
  if (!section.has("sun_position")) section.fault("a sky of Perez needs sun_position; add it");
  if (!direct || !diffuse || !sun) return {};
  const double zenith = (90 - sun->altitude) * one_degree;
  const SkyConditions conditions = sky_conditions(*direct, *diffuse, zenith, sun->eccentricity);
  if (!fill_table(perez_sky(conditions, zenith), *sun, light))
    section.fault(
        "diffuse_horizontal_irradiance",
        fmt::format("gives a sky of clearness {:.4g} and brightness {:.4g}, for which the model of Perez is "
                    "negative or infinite somewhere; use other irradiances or cie_type",
                    conditions.clearness, conditions.brightness));
  const double efficacy = diffuse_luminous_efficacy(conditions, zenith);
  light.note = fmt::format("Perez, clearness {:.4g}, brightness {:.4g}, {:.4g} lm/W, {}",
                           conditions.clearness, conditions.brightness, efficacy, light.note);
  return efficacy * *diffuse;
}

}  // namespace

std::optional<double> read_daylight(Section& section, LightCase& light) {
  const std::optional<SunPlace> sun = read_sun_position(section);
  if (sun)
    light.note = fmt::format("sun at altitude {:.2f}, azimuth {:.2f} degrees", sun->altitude, sun->azimuth);
  if (light.kind == LightKind::sun) {
    if (!section.has("direction") && !section.has("sun_position"))
      section.fault("a light of kind sun needs direction or sun_position; add one of them");
    if (section.has("sun_position")) section.unused("direction", "`sun_position` is given");
    if (sun) light.direction = -sun->to_sun;
    return {};
  }
  const auto type = section.number_if("cie_type");
  const bool perez = section.has("direct_normal_irradiance") || section.has("diffuse_horizontal_irradiance");
  if (!section.has("cie_type") && !perez) {
    section.unused("sun_position", "only a CIE sky or a sky of Perez depends on the sun");
    return {};
  }
  for (const char* key : {"distribution", "direction", "along"})
    section.unused(key, "the sky is given by its model, with its zenith along z");
  if (!type) return perez ? read_perez_sky(section, sun, light) : std::nullopt;
  read_cie_sky(section, static_cast<int>(*type), sun, light);
  return {};
}

}  // namespace etendue
