// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/daylight.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>

#include "app/case/build/sky_parts.h"

namespace etendue {
namespace {

bool is_sky(const LightCase& light) { return light.kind == LightKind::sky; }

bool shines(const std::optional<BandValues>& values) {
  return values && std::ranges::any_of(values->values, [](const Value& value) {
           const double* number = std::get_if<double>(&value);
           return number == nullptr || *number != 0;
         });
}

/// What shines beside one sky; empty where nothing does.
std::string other_light(const Case& input) {
  for (const LightCase& light : input.lights)
    if (!is_sky(light)) return "the light \"" + light.name + "\"";
  for (const auto& [name, wall] : input.walls)
    if (shines(wall.radiance)) return "the wall \"" + name + "\"";
  for (const auto& [name, medium] : input.media)
    if (shines(medium.emission) || shines(medium.power_density) || shines(medium.power))
      return "the medium \"" + name + "\"";
  return {};
}

}  // namespace

void check_daylight_factors(const Case& input, Faults& faults) {
  const auto skies = std::ranges::count_if(input.lights, is_sky);
  const std::string other = other_light(input);
  for (const SensorCase& sensor : input.sensors) {
    if (!sensor.daylight_factor) continue;
    if (!other.empty())
      faults.push_back(fault_at(*sensor.daylight_factor, "true",
                                other +
                                    " shines too (a daylight factor is of the sky alone, without the sun and "
                                    "lamps); remove it"));
    else if (skies != 1)
      faults.push_back(
          fault_at(*sensor.daylight_factor, "true",
                   (skies == 0 ? std::string("the case has no sky")
                               : "the case has " + std::to_string(skies) + " skies") +
                       "; use one [[light]] of kind \"sky\", for all walls by which it comes in"));
  }
}

std::vector<double> unobstructed_irradiance(const LightCase& light) {
  std::vector<double> sum = values_of(light.strength);
  const auto scale = [&](double factor) {
    for (double& value : sum) value *= factor;
  };
  if (!is_sky(light)) {
    scale(std::max(0.0, -light.direction.z()));
  } else if (light.angle.empty()) {
    // Without a table the sky has the same radiance L all over: pi L, unless that is what is given.
    scale(std::holds_alternative<IrradianceOfLight>(light.strength) ? 1 : std::numbers::pi);
  } else {
    std::ranges::fill(sum, 0);
    for (const BeamLight& part : sky_parts(light, {})) {
      const double cosine = std::max(0.0, part.direction.dot(light.direction));
      for (std::size_t b = 0; b < sum.size(); ++b) sum[b] += part.irradiance[b] * cosine;
    }
  }
  return sum;
}

std::vector<double> unobstructed_sky_irradiance(const Case& input) {
  return unobstructed_irradiance(*std::ranges::find_if(input.lights, is_sky));
}

}  // namespace etendue
