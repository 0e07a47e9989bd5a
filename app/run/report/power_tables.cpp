// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "app/run/report/report_parts.h"
#include "app/write/result/unit_labels.h"

namespace etendue {
namespace {

constexpr std::size_t longest_probe_table = 12;
// Relative; a smaller deviation of the emitted power is rounding.
constexpr double noticeable_deviation = 1e-9;

/// A column's heading with its unit.
std::string with_unit(const std::string& name, const std::string& unit) { return name + " [" + unit + "]"; }

/// Where the discrete half range differs from pi, so does the power of an emitting wall.
std::string emitted_power_text(const RunResult& result, const std::string& unit) {
  std::string text;
  for (std::size_t w = 0; w < result.walls.size(); ++w)
    for (std::size_t b = 0; b < result.walls[w].size(); ++b) {
      const WallPower& power = result.walls[w][b];
      const double deviation = power.emitted - power.emitted_exact;
      if (std::abs(deviation) <= noticeable_deviation * std::abs(power.emitted_exact)) continue;
      text +=
          fmt::format("  {} emits {:.6g} {} in band {} on these directions; {} L A = {:.6g} ({:+.2g} %)\n",
                      result.problem.walls()[w].name, power.emitted, unit, band_name(result, b),
                      result.problem.space() == AngularSpace::sphere ? "pi" : "2", power.emitted_exact,
                      100 * deviation / power.emitted_exact);
    }
  return text;
}

std::string walls_text(const RunResult& result, const UnitLabels& units) {
  TextTable table(
      {"wall", "band", with_unit("area", units.area), with_unit("irradiance", units.flux),
       with_unit("incoming", units.power), with_unit("outgoing", units.power), with_unit("net", units.power)},
      {Align::left, Align::left, Align::right, Align::right, Align::right, Align::right, Align::right});
  for (std::size_t w = 0; w < result.walls.size(); ++w)
    for (std::size_t b = 0; b < result.walls[w].size(); ++b) {
      const WallPower& power = result.walls[w][b];
      const WallPower error = result.errors ? result.errors->walls[w][b] : WallPower{};
      table.add_row({result.problem.walls()[w].name, band_name(result, b), number(power.area),
                     number(power.irradiance_mean, error.irradiance_mean),
                     number(power.incoming, error.incoming), number(power.outgoing, error.outgoing),
                     number(power.incoming - power.outgoing, result.errors ? result.errors->net[w][b] : 0)});
    }
  return titled("walls", table);
}

std::string regions_text(const RunResult& result, const UnitLabels& units) {
  TextTable table({"region", "band", with_unit("volume", units.volume), with_unit("fluence", units.flux),
                   with_unit("absorbed", units.power), with_unit("emitted", units.power)},
                  {Align::left, Align::left, Align::right, Align::right, Align::right, Align::right});
  for (std::size_t r = 0; r < result.regions.size(); ++r)
    for (std::size_t b = 0; b < result.regions[r].size(); ++b) {
      const RegionPower& power = result.regions[r][b];
      const RegionPower error = result.errors ? result.errors->regions[r][b] : RegionPower{};
      table.add_row({result.problem.media()[r].name, band_name(result, b), number(power.volume),
                     number(power.fluence_mean, error.fluence_mean), number(power.absorbed, error.absorbed),
                     number(power.emitted)});
    }
  return titled("regions", table);
}

}  // namespace

std::string powers_text(const RunResult& result) {
  const UnitLabels units(result.input.units);
  const std::size_t bands = result.problem.bands().names.size();
  std::string text = emitted_power_text(result, units.power);
  text += result.walls.size() * bands <= longest_report_table ? walls_text(result, units)
                                                              : "\nwalls: many, see walls.csv\n";
  text += result.regions.size() * bands <= longest_report_table ? regions_text(result, units)
                                                                : "\nregions: many, see regions.csv\n";
  return text + heat_text(result);
}

std::string probes_text(const RunResult& result) {
  const std::size_t bands = result.problem.bands().names.size();
  if (result.probes.empty()) return "";
  if (result.probes.size() * bands > longest_probe_table)
    return fmt::format("\nprobes: {} points, see probes.csv\n", result.probes.size());
  const UnitLabels units(result.input.units);
  TextTable table({"probe", with_unit("x", units.length), with_unit("y", units.length),
                   with_unit("z", units.length), "band", with_unit("fluence", units.flux),
                   with_unit("net flux", units.flux), with_unit("irradiance", units.flux)},
                  {Align::left, Align::right, Align::right, Align::right, Align::left, Align::right,
                   Align::right, Align::right});
  for (const ProbeRow& row : result.probes)
    for (std::size_t b = 0; b < bands; ++b) {
      const ProbeValue error = row.errors ? row.errors->values[b] : ProbeValue{};
      const double irradiance_error = row.errors && row.errors->irradiance ? (*row.errors->irradiance)[b] : 0;
      const auto& flux = row.values[b].net_flux;
      table.add_row({row.name, number(row.point.x()), number(row.point.y()), number(row.point.z()),
                     band_name(result, b), number(row.values[b].fluence, error.fluence),
                     number(std::hypot(flux[0], flux[1], flux[2]),
                            std::hypot(error.net_flux[0], error.net_flux[1], error.net_flux[2])),
                     row.irradiance ? number((*row.irradiance)[b], irradiance_error) : ""});
    }
  return titled("probes", table);
}

}  // namespace etendue
