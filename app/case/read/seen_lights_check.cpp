// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/seen_lights_check.h"

#include <fmt/format.h>

#include <algorithm>

namespace etendue {
namespace {

/// Whether the light comes from outside: rays meet no cell that sends it. A sky of the same radiance all over
/// is a wall that shines, but for glazing.
bool comes_from_outside(const LightCase& light, const Case& input) {
  const bool glazed =
      std::ranges::any_of(input.walls, [](const auto& wall) { return !wall.second.glazing.empty(); });
  return light.kind == LightKind::sun || light.kind == LightKind::beam ||
         (light.kind == LightKind::sky && (!light.angle.empty() || glazed));
}

/// Name of a light that rays do not know; empty without any.
std::string unseen_light(const Case& input) {
  for (const LightCase& light : input.lights)
    if (light.uncollided == Uncollided::no && comes_from_outside(light, input)) return light.name;
  for (const auto& [name, wall] : input.walls)
    if (wall.beam && wall.uncollided == Uncollided::no) return wall.beam->name;
  return {};
}

bool counts_directions(const SensorCase& sensor) {
  return sensor.sensor.kind == SensorKind::region || !sensor.region.empty();
}

}  // namespace

void check_sensors_see_lights(const Case& input, Faults& faults) {
  const std::string light = unseen_light(input);
  if (light.empty()) return;
  for (const SensorCase& sensor : input.sensors)
    if (!counts_directions(sensor))
      faults.push_back(fault_at(
          sensor.origin, "",
          fmt::format("the sensor \"{}\" does not see the light \"{}\", which is left to the directions "
                      "(uncollided = false); leave that key out, or use a [[probe]] with a normal",
                      sensor.name, light)));
}

}  // namespace etendue
