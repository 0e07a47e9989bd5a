// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/time/heat_numbers.h"

#include <fmt/format.h>

#include "app/case/build/entry_of.h"
#include "app/write/result/heat_rows.h"
#include "app/write/result/temperature_fields.h"

namespace etendue {
namespace {

constexpr const char* all_bands = "all";

}  // namespace

HeatNumbers::HeatNumbers(const Case& input, const Problem& problem, const CellLocator& locator)
    : input_(input), problem_(problem) {
  const auto add = [&](const char* quantity, const std::string& name, const char* unit) {
    quantities_.push_back({quantity, name, all_bands, unit});
  };
  const TetrahedralMesh& mesh = problem.mesh();
  for (const Probe& probe : input.probes)
    for (std::size_t i = 0; i < probe.points.size(); ++i) {
      const CellPoint place = locator.find(probe.points[i]).front();
      const auto region = static_cast<std::size_t>(mesh.region(place.cell));
      if (!entry_of(input.media, mesh.region_names()[region]).iterates_temperature()) continue;
      places_.push_back(place);
      add("temperature", fmt::format("probe {} {}", probe.name, i), "K");
    }
  for (const std::string& wall : mesh.wall_names()) {
    add("temperature", "wall " + wall, "K");
    for (const char* quantity : {"net_heat", "conducted", "convected"}) add(quantity, "wall " + wall, "W");
  }
  for (const std::string& region : mesh.region_names()) {
    add("temperature", "region " + region, "K");
    add("net_heat", "region " + region, "W");
  }
  add("stored_heat", "all", "J");
}

std::vector<double> HeatNumbers::values(const Solution& solution, const HeatSolution& heat,
                                        double stored) const {
  const RunResult now{.input = input_,
                      .problem = problem_,
                      .solution = solution,
                      .probes = {},
                      .balances = {},
                      .walls = wall_powers(problem_, solution),
                      .regions = region_powers(problem_, solution),
                      .seconds = {},
                      .heat = heat};
  std::vector<double> values;
  for (const CellPoint& place : places_) values.push_back(iterated_temperature(heat, place));
  for (const HeatRow& row : heat_rows(now)) {
    values.push_back(row.temperature);
    values.push_back(row.net);
    if (!row.is_wall) continue;
    values.push_back(row.conducted);
    values.push_back(row.convected);
  }
  values.push_back(stored);
  return values;
}

}  // namespace etendue
