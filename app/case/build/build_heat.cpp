// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/build_heat.h"

#include <algorithm>
#include <cmath>

#include "app/case/build/entry_of.h"
#include "app/case/build/temperature_range.h"
#include "app/case/temperatures.h"
#include "app/case/values/value_algebra.h"

namespace etendue {
namespace {

Coefficient coefficient_or_zero(const std::optional<BandValues>& value) {
  return value ? coefficient_of(value->values.front()) : Coefficient(0.0);
}

/// Of all that is given; 300 K where nothing is.
double usual_temperature(const Case& input, const TetrahedralMesh& mesh) {
  double sum = 0, count = 0;
  for (const TemperatureRange& range : temperature_ranges(input, mesh)) {
    sum += std::pow(range.mean, 4);
    ++count;
  }
  for (const std::string& name : mesh.wall_names())
    if (const WallCase wall = entry_of(input.walls, name); wall.convection) {
      sum += std::pow(wall.convection->ambient, 4);
      ++count;
    }
  return sum > 0 ? std::pow(sum / count, 0.25) : HeatProblem{}.start;
}

}  // namespace

std::optional<HeatProblem> build_heat(const Case& input, const TetrahedralMesh& mesh) {
  if (!iterates_temperatures(input)) return std::nullopt;
  HeatProblem heat;
  heat.start = usual_temperature(input, mesh);
  for (const std::string& name : mesh.region_names()) {
    const MediumCase medium = entry_of(input.media, name);
    heat.media.emplace_back();
    if (!medium.iterates_temperature()) continue;
    heat.media.back() = HeatMedium{coefficient_or_zero(medium.conductivity),
                                   coefficient_or_zero(medium.heat_source), medium.origin};
  }
  for (const std::string& name : mesh.wall_names()) {
    const WallCase wall = entry_of(input.walls, name);
    heat.wall_temperatures.emplace_back();
    if (wall.temperature) heat.wall_temperatures.back() = coefficient_of(wall.temperature->values.front());
    heat.walls.emplace_back();
    if (!wall.iterates_temperature()) continue;
    const Convection convection = wall.convection.value_or(Convection{});
    heat.walls.back() =
        HeatWall{wall.heat_flux.value_or(0), convection.heat_transfer_coefficient, convection.ambient};
  }
  const auto follows = [](const auto& entry) { return entry.has_value(); };
  if (std::ranges::none_of(heat.media, follows) && std::ranges::none_of(heat.walls, follows))
    return std::nullopt;
  return heat;
}

}  // namespace etendue
