// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/case/build/entry_of.h"
#include "app/case/temperatures.h"
#include "app/case/values/blackbody_values.h"
#include "app/run/report/report_parts.h"
#include "app/write/result/heat_rows.h"

namespace etendue {
namespace {

/// Width of a cell in absorption lengths up to which linear emission does: the flux at a wall of a slab with
/// a linear temperature is then off by half a percent.
constexpr double thin_cell = 1.2;
/// Cells over the layer at a wall up to which conducted heat is off by some percent.
constexpr double coarsest_layer = 2;
/// Of a blackbody's power, without a caution.
constexpr double largest_part_outside = 0.02;

/// Of layers at walls that the cells do not resolve.
std::string layer_caution(const RunResult& result) {
  if (!result.heat || result.heat->cells_per_layer <= coarsest_layer) return "";
  return fmt::format(
      "caution: cells at walls are up to {:.2g} times as thick as the layer in which conduction gives way to "
      "radiation; "
      "conducted heat may be far off; use finer cells there\n",
      result.heat->cells_per_layer);
}

/// With what is conducted into walls and carried away from them by convection.
std::string other_heat_text(const RunResult& result, const std::vector<HeatRow>& rows) {
  if (!result.heat) return "";
  TextTable table({"wall", "conducted [W]", "with radiation [W]", "convected [W]"},
                  {Align::left, Align::right, Align::right, Align::right});
  double conducted = 0, convected = 0;
  for (const HeatRow& row : rows)
    if (row.conducted != 0 || row.convected != 0) {
      table.add_row(
          {row.name, number(row.conducted, 0), number(row.conducted + row.net, 0), number(row.convected, 0)});
      conducted += row.conducted;
      convected += row.convected;
    }
  if (table.empty()) return "";
  return fmt::format(
      "\nheat besides radiation\n{}  {:.6g} W are conducted into the walls, and {:.6g} W carried away by "
      "convection\n{}",
      table.text(), conducted, convected, layer_caution(result));
}

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
    const MediumCase medium = entry_of(result.input.media, name);
    const auto& temperature = medium.temperature;
    changes.push_back(medium.iterates_temperature() ||
                      (temperature && std::holds_alternative<Formula>(temperature->values.front())));
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

/// Of temperatures that followed, which are not known before.
std::string range_caution(const RunResult& result) {
  if (!result.heat) return "";
  const Bands& bands = result.problem.bands();
  const double highest =
      std::max(std::ranges::max(result.heat->temperature), std::ranges::max(result.heat->wall_temperature));
  if (!bands.gas.gases.empty() && highest > bands.gas.highest)
    return fmt::format(
        "caution: temperatures of up to {:.5g} K: the gray gases of the bands are known up to {:g} K\n",
        highest, bands.gas.highest);
  const double outside = fraction_outside_bands(highest, bands);
  if (outside <= largest_part_outside) return "";
  return fmt::format(
      "caution: {:.2g} % of the power of a blackbody of {:.5g} K is outside of bands.edges; use wider ones\n",
      100 * outside, highest);
}

std::string caution_of(const RunResult& result) {
  const double thickest = thickest_cell(result);
  if (thickest <= thin_cell) return range_caution(result);
  return range_caution(result) + fmt::format(
                                     "caution: cells with a temperature gradient are up to {:.2g} absorption "
                                     "lengths wide; heat fluxes "
                                     "there may be "
                                     "off by some percent; use finer cells, below {:g} of a length\n",
                                     thickest, thin_cell);
}

}  // namespace

std::string heat_text(const RunResult& result) {
  if (!has_temperatures(result.input)) return "";
  const std::vector<HeatRow> rows = heat_rows(result);
  if (rows.size() > longest_report_table) return "\nradiative heat: many walls and regions, see heat.csv\n";
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
  return fmt::format("\nradiative heat\n{}{}  {:.6g} W leave the media, {}and {:.6g} W enter the walls\n{}{}",
                     walls.text(), regions.text(), out_of_regions, from_lights, into_walls,
                     caution_of(result), other_heat_text(result, rows));
}

}  // namespace etendue
