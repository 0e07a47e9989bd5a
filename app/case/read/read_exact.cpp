// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/read_exact.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/case/exact_family.h"
#include "app/case/keys/case_tables.h"
#include "base/errors.h"
#include "base/expression/differentiable.h"

namespace etendue {
namespace {

bool is_zero(const BandValues& values) {
  return std::ranges::all_of(values.values, [](const Value& value) {
    const double* number = std::get_if<double>(&value);
    return number != nullptr && *number == 0;
  });
}

void refuse_emission(const BandValues& values, std::string_view why, Faults& faults) {
  if (!is_zero(values)) faults.push_back(fault_at(values.origin, "", why));
}

void check_sources(const Case& input, Faults& faults) {
  for (const auto& [name, medium] : input.media)
    for (const auto* values : {&medium.emission, &medium.power_density, &medium.power})
      if (*values)
        refuse_emission(**values,
                        "emits in a case with [exact] (its source follows from the radiance); remove it",
                        faults);
}

void refuse_lights(const Case& input, Faults& faults) {
  for (const LightCase& light : input.lights)
    faults.push_back(
        fault_at(light.origin, "",
                 "a light in a case with [exact] (what enters follows from the radiance); remove it"));
}

void check_walls(const Case& input, Faults& faults) {
  for (const auto& [name, wall] : input.walls) {
    refuse_emission(wall.radiance,
                    "emits in a case with [exact] (what enters follows from the radiance); remove it",
                    faults);
    for (const BandValues* reflectance : {&wall.diffuse, &wall.specular, &wall.transmittance})
      refuse_emission(*reflectance, "reflects in a case with [exact] (not in this version); use black walls",
                      faults);
    if (!wall.glossy.empty())
      faults.push_back(fault_at(wall.origin, "",
                                "reflects in a case with [exact] (not in this version); use black walls"));
  }
}

/// The source is known at the ordinates alone.
void check_views(const Case& input, Faults& faults) {
  constexpr std::string_view why =
      "in a case with [exact], whose source rays do not see (not in this version); remove it, or use a probe";
  for (const CameraCase& camera : input.cameras)
    faults.push_back(fault_at(camera.origin, "", fmt::format("a camera {}", why)));
  for (const SensorCase& sensor : input.sensors)
    faults.push_back(fault_at(sensor.origin, "", fmt::format("a sensor {}", why)));
}

void read_family(Section& exact, Case& result) {
  exact.unused("radiance", "the family says what it is");
  const auto name = exact.text_if("family");
  if (!name) return;
  ExactFamily family;
  family.name = *name;
  if (family.name == "polynomial")
    exact_family_table().read(exact, "degree", family);
  else
    exact.unused("degree", "only the polynomial takes it");
  for (const char* key : {"center", "length"}) exact_family_table().read(exact, key, family);
  result.exact = ExactCase{exact_formula(family), family, exact.origin("family")};
}

}  // namespace

void read_exact(Section exact, Case& result) {
  check_sources(result, exact.faults());
  check_walls(result, exact.faults());
  refuse_lights(result, exact.faults());
  check_views(result, exact.faults());
  if (exact.has("family")) return read_family(exact, result);
  for (const char* name : {"degree", "center", "length"}) exact.unused(name, "only a family takes it");
  const auto radiance = exact.text_if("radiance");
  if (!radiance) {
    if (!exact.has("radiance")) exact.fault("says nothing; give a radiance or a family");
    return;
  }
  try {
    DifferentiableExpression(*radiance, {"x", "y", "z", "wx", "wy", "wz"});
    result.exact = ExactCase{*radiance, {}, exact.origin("radiance")};
  } catch (const InputError& error) {
    exact.fault("radiance", error.faults().front().text);
  }
}

}  // namespace etendue
