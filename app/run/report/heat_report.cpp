// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/case/build/entry_of.h"
#include "app/case/temperatures.h"
#include "app/progress/text_table.h"
#include "app/run/report/run_report.h"
#include "app/write/result/heat_rows.h"

namespace etendue {
namespace {

/// Rows beyond which the table is left to heat.csv.
constexpr std::size_t longest_table = 40;
/// Width of a cell in absorption lengths up to which linear emission does: the flux at a wall of a slab with
/// a linear temperature is then off by half a percent.
constexpr double thin_cell = 1.2;

void add(TextTable& table, const HeatRow& row) {
  table.add_row({row.name, number(row.extent), number(row.emitted), number(row.absorbed),
                 number(row.net, row.error),
                 number(row.density(), row.extent > 0 ? row.error / row.extent : 0),
                 row.temperature > 0 ? fmt::format("{:.6g}", row.temperature) : ""});
}

TextTable table_of(const char* kind, const char* extent, const char* net, const char* density) {
  return TextTable(
      {kind, extent, "emitted [W]", "absorbed [W]", net, density, "mean [K]"},
      {Align::left, Align::right, Align::right, Align::right, Align::right, Align::right, Align::right});
}

/// Power of lights: of all that enters from walls and lights what walls do not emit themselves.
double power_of_lights(const RunResult& result) {
  double power = 0;
  for (const Balance& balance : result.balances) power += balance.inflow;
  for (const std::vector<WallPower>& wall : result.walls)
    for (const WallPower& band : wall) power -= band.emitted;
  return power;
}

/// Largest optical thickness of cells by absorption, in regions whose temperature changes with the place.
double thickest_cell(const RunResult& result) {
  const Problem& problem = result.problem;
  std::vector<char> changes;
  for (const std::string& name : problem.mesh().region_names()) {
    const std::optional<BandValues> temperature = entry_of(result.input.media, name).temperature;
    changes.push_back(temperature && std::holds_alternative<Formula>(temperature->values.front()));
  }
  double thickest = 0;
  for (std::int32_t c = 0; c < problem.mesh().cell_count(); ++c) {
    const CellIndex cell(c);
    if (changes[static_cast<std::size_t>(problem.mesh().region(cell))] == 0) continue;
    for (int band = 0; band < problem.band_count(); ++band)
      thickest = std::max(thickest, problem.absorption(cell, band) * std::cbrt(problem.mesh().volume(cell)));
  }
  return thickest;
}

std::string caution_of(const RunResult& result) {
  const double thickest = thickest_cell(result);
  if (thickest <= thin_cell) return "";
  return fmt::format(
      "caution: cells with a temperature gradient are up to {:.2g} absorption lengths wide; heat fluxes "
      "there may be "
      "off by some percent; use finer cells, below {:g} of a length\n",
      thickest, thin_cell);
}

}  // namespace

std::string heat_text(const RunResult& result) {
  if (!has_temperatures(result.input)) return "";
  const std::vector<HeatRow> rows = heat_rows(result);
  if (rows.size() > longest_table) return "\nradiative heat: many walls and regions, see heat.csv\n";
  TextTable walls = table_of("wall", "area [m^2]", "net heat [W]", "heat flux [W/m^2]");
  TextTable regions = table_of("region", "volume [m^3]", "net heat [W]", "divergence [W/m^3]");
  double into_walls = 0, out_of_regions = 0;
  for (const HeatRow& row : rows) {
    add(row.is_wall ? walls : regions, row);
    (row.is_wall ? into_walls : out_of_regions) += row.net;
  }
  const double lights = power_of_lights(result);
  const std::string from_lights = std::abs(lights) > 1e-6 * std::abs(into_walls)
                                      ? fmt::format("{:.6g} W come from lights, ", lights)
                                      : "";
  return fmt::format("\nradiative heat\n{}{}  {:.6g} W leave the media, {}and {:.6g} W enter the walls\n{}",
                     walls.text(), regions.text(), out_of_regions, from_lights, into_walls,
                     caution_of(result));
}

}  // namespace etendue
