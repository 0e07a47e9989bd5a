// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/lamp_light.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <variant>

#include "app/case/build/daylight.h"
#include "solver/observe/color/photometry.h"

namespace etendue {

std::vector<LampLight> lamp_lights(const Problem& problem, const Case& input) {
  const Photometry photometry(problem.bands());
  const std::optional<double> watts = watts_of_unit(input.units.power);
  std::vector<LampLight> lamps;
  if (!photometry.known() || !watts) return lamps;
  for (const Light& light : problem.lights()) {
    const auto* point = std::get_if<PointLight>(&light.kind);
    if (point == nullptr) continue;
    const double power = std::accumulate(point->power.begin(), point->power.end(), 0.0);
    const double lumens = *watts * photometry.luminous(point->power);
    const auto written = std::ranges::find(input.lights, light.name, &LightCase::name);
    lamps.push_back({light.name, power, lumens, power > 0 ? lumens / (*watts * power) : 0,
                     written == input.lights.end() ? "" : written->note});
  }
  return lamps;
}

std::vector<Daylight> daylight(const Case& input) {
  const Photometry photometry(input.bands);
  const std::optional<SiScale> scale = si_scale(input.units.length, input.units.power);
  std::vector<Daylight> found;
  for (const LightCase& light : input.lights) {
    if (light.of_wall || (light.kind != LightKind::sun && light.kind != LightKind::sky)) continue;
    const std::vector<double> level = unobstructed_irradiance(light);
    Daylight& day = found.emplace_back();
    day.name = light.name;
    day.note = light.note;
    day.irradiance = std::accumulate(level.begin(), level.end(), 0.0);
    if (scale && photometry.known())
      day.illuminance = photometry.luminous(level) * scale->power / (scale->length * scale->length);
  }
  return found;
}

std::vector<WallBeam> wall_beams(const Problem& problem, const Case& input) {
  const TetrahedralMesh& mesh = problem.mesh();
  std::vector<WallBeam> found;
  for (const LightCase& light : input.lights) {
    if (!light.of_wall) continue;
    double area = 0;  // across the beam
    for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
      const FaceIndex face(f);
      if (mesh.wall_names()[static_cast<std::size_t>(mesh.wall(face))] == light.walls.front())
        area += std::max(0.0, -mesh.area_normal(face).dot(light.direction));
    }
    const std::vector<double>& bands = values_of(light.strength);
    const double irradiance = std::accumulate(bands.begin(), bands.end(), 0.0);
    found.push_back({light.name, irradiance, irradiance * area});
  }
  return found;
}

}  // namespace etendue
