// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/build_heat.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/case/build/entry_of.h"
#include "app/case/build/temperature_range.h"
#include "app/case/temperatures.h"
#include "app/case/values/in_time_value.h"
#include "app/case/values/value_algebra.h"

namespace etendue {
namespace {

Coefficient coefficient_or_zero(const std::optional<BandValues>& value) {
  return value ? coefficient_of(value->values.front()) : Coefficient(0.0);
}

ThermalProperty property_or_zero(const std::optional<BandValues>& value) {
  if (!value) return 0.0;
  const auto* formula = std::get_if<Formula>(&value->values.front());
  if (formula == nullptr) return coefficient_of(value->values.front());
  Expression expression(*formula, {"x", "y", "z", "T"});
  if (expression.uses("T")) return ThermalProperty(std::move(expression));
  return coefficient_of(value->values.front());
}

/// Of a medium or wall.
template <class Entry>
HeatInTime heat_in_time(const Entry& entry) {
  HeatInTime heat{property_or_zero(entry.heat_capacity), std::nullopt, {}};
  if (entry.initial_temperature) heat.initial = coefficient_of(entry.initial_temperature->values.front());
  if (entry.in_time) heat.factor = factor_in_time(*entry.in_time);
  return heat;
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
  heat.changes_in_time = steps_temperatures(input);
  for (const std::string& name : mesh.region_names()) {
    const MediumCase medium = entry_of(input.media, name);
    heat.media.emplace_back();
    if (!medium.iterates_temperature()) continue;
    heat.media.back() =
        HeatMedium{property_or_zero(medium.conductivity), coefficient_or_zero(medium.heat_source),
                   medium.origin, heat_in_time(medium)};
  }
  for (const std::string& name : mesh.wall_names()) {
    const WallCase wall = entry_of(input.walls, name);
    heat.wall_temperatures.emplace_back();
    // That of a smooth surface is what radiates behind it.
    if (wall.temperature && wall.refractive_index == 1)
      heat.wall_temperatures.back() = coefficient_of(wall.temperature->values.front());
    heat.walls.emplace_back();
    if (!wall.iterates_temperature()) continue;
    const Convection convection = wall.convection.value_or(Convection{});
    heat.walls.back() = HeatWall{wall.heat_flux.value_or(0), convection.heat_transfer_coefficient,
                                 convection.ambient, heat_in_time(wall), wall.origin};
  }
  const auto follows = [](const auto& entry) { return entry.has_value(); };
  if (std::ranges::none_of(heat.media, follows) && std::ranges::none_of(heat.walls, follows))
    return std::nullopt;
  return heat;
}

}  // namespace etendue
