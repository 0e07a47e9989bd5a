// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/lamp_light.h"

#include <numeric>
#include <variant>

#include "solver/sensors/photometry.h"

namespace etendue {

std::vector<LampLight> lamp_lights(const Problem& problem, const Units& units) {
  const Photometry photometry(problem.bands());
  const std::optional<double> watts = watts_of_unit(units.power);
  std::vector<LampLight> lamps;
  if (!photometry.known() || !watts) return lamps;
  for (const Light& light : problem.lights()) {
    const auto* point = std::get_if<PointLight>(&light.kind);
    if (point == nullptr) continue;
    const double power = std::accumulate(point->power.begin(), point->power.end(), 0.0);
    const double lumens = *watts * photometry.luminous(point->power);
    lamps.push_back({light.name, power, lumens, power > 0 ? lumens / (*watts * power) : 0});
  }
  return lamps;
}

}  // namespace etendue
