// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/csv/tables.h"

#include <fmt/format.h>

#include <initializer_list>
#include <iterator>

#include "app/case/temperatures.h"
#include "app/write/csv/csv_field.h"
#include "app/write/result/heat_rows.h"

namespace etendue {
namespace {

template <class... Values>
void add_row(std::string& table, fmt::format_string<Values...> row, Values&&... values) {
  fmt::format_to(std::back_inserter(table), row, std::forward<Values>(values)...);
  table += '\n';
}

bool with_errors(const RunResult& result) { return result.errors.has_value(); }

/// Numbers as more columns of a row.
std::string columns(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) text += fmt::format(",{}", number);
  return text;
}

std::string probe_errors(const ProbeRow& row, std::size_t band) {
  if (!row.errors) return "";
  const ProbeValue& error = row.errors->values[band];
  return columns({error.fluence, error.net_flux[0], error.net_flux[1], error.net_flux[2]}) + "," +
         (row.errors->irradiance ? fmt::to_string((*row.errors->irradiance)[band]) : "");
}

}  // namespace

std::string probes_csv(const RunResult& result) {
  const std::vector<std::string>& bands = result.problem.bands().names;
  const bool with_field = !result.solution.lights.fluence.empty();
  std::string table = "probe,index,x,y,z,band,fluence,flux_x,flux_y,flux_z,irradiance";
  const bool with_temperature = has_temperatures(result.input);
  table += with_field ? ",fluence_field" : "";
  table += with_temperature ? ",temperature" : "";
  table +=
      with_errors(result) ? ",fluence_error,flux_x_error,flux_y_error,flux_z_error,irradiance_error\n" : "\n";
  for (const ProbeRow& row : result.probes)
    for (std::size_t b = 0; b < bands.size(); ++b) {
      const ProbeValue& value = row.values[b];
      add_row(table, "{},{},{},{},{},{},{},{},{},{},{}{}{}{}", csv_field(row.name), row.index, row.point.x(),
              row.point.y(), row.point.z(), csv_field(bands[b]), value.fluence, value.net_flux[0],
              value.net_flux[1], value.net_flux[2],
              row.irradiance ? fmt::to_string((*row.irradiance)[b]) : "",
              with_field ? fmt::format(",{}", (*row.fluence_field)[b]) : "",
              with_temperature ? "," + (row.temperature ? fmt::to_string(*row.temperature) : "") : "",
              probe_errors(row, b));
    }
  return table;
}

std::string walls_csv(const RunResult& result) {
  const std::vector<std::string>& bands = result.problem.bands().names;
  std::string table = "wall,band,area,irradiance_mean,incoming,outgoing,net";
  table += with_errors(result) ? ",irradiance_mean_error,incoming_error,outgoing_error,net_error\n" : "\n";
  for (std::size_t w = 0; w < result.walls.size(); ++w)
    for (std::size_t b = 0; b < bands.size(); ++b) {
      const WallPower& power = result.walls[w][b];
      std::string errors;
      if (result.errors) {
        const WallPower& error = result.errors->walls[w][b];
        errors = columns({error.irradiance_mean, error.incoming, error.outgoing, result.errors->net[w][b]});
      }
      add_row(table, "{},{},{},{},{},{},{}{}", csv_field(result.problem.walls()[w].name), csv_field(bands[b]),
              power.area, power.irradiance_mean, power.incoming, power.outgoing,
              power.incoming - power.outgoing, errors);
    }
  return table;
}

std::string regions_csv(const RunResult& result) {
  const std::vector<std::string>& bands = result.problem.bands().names;
  std::string table = "region,band,volume,fluence_mean,absorbed,emitted";
  table += with_errors(result) ? ",fluence_mean_error,absorbed_error\n" : "\n";
  for (std::size_t r = 0; r < result.regions.size(); ++r)
    for (std::size_t b = 0; b < bands.size(); ++b) {
      const RegionPower& power = result.regions[r][b];
      std::string errors;
      if (result.errors) {
        const RegionPower& error = result.errors->regions[r][b];
        errors = columns({error.fluence_mean, error.absorbed});
      }
      add_row(table, "{},{},{},{},{},{}{}", csv_field(result.problem.media()[r].name), csv_field(bands[b]),
              power.volume, power.fluence_mean, power.absorbed, power.emitted, errors);
    }
  return table;
}

std::string heat_csv(const RunResult& result) {
  std::string table = "kind,name,extent,emitted,absorbed,net,density,temperature";
  if (result.heat) table += ",conducted,convected";
  table += result.errors ? ",net_error\n" : "\n";
  for (const HeatRow& row : heat_rows(result))
    table +=
        fmt::format("{},{},{},{},{},{},{},{}{}{}\n", row.is_wall ? "wall" : "region", csv_field(row.name),
                    row.extent, row.emitted, row.absorbed, row.net, row.density(), row.temperature,
                    result.heat ? fmt::format(",{},{}", row.conducted, row.convected) : "",
                    result.errors ? fmt::format(",{}", row.error) : "");
  return table;
}

std::string passes_csv(const RunResult& result) {
  const std::vector<std::string>& bands = result.problem.bands().names;
  std::string table = "pass,band,exitant,incident,redirected,deposit\n";
  for (const Bounce& bounce : result.radiosity->bounces)
    add_row(table, "{},{},{},{},{},{}", bounce.pass, csv_field(bands[bounce.band]), bounce.exitant,
            bounce.incident, bounce.redirected, bounce.deposit);
  return table;
}

std::string form_factors_csv(const RunResult& result) {
  const std::vector<std::string>& walls = result.problem.mesh().wall_names();
  std::string table = "from,to,factor\n";
  for (std::size_t a = 0; a < walls.size(); ++a)
    for (std::size_t b = 0; b < walls.size(); ++b)
      add_row(table, "{},{},{}", csv_field(walls[a]), csv_field(walls[b]),
              result.radiosity->wall_factors[a * walls.size() + b]);
  return table;
}

std::string positivity_csv(const RunResult& result) {
  const std::vector<std::string>& bands = result.problem.bands().names;
  std::string table = "ordinate,wx,wy,wz,weight,band,cells,failed,smallest,moved\n";
  for (const OrdinateFixup& fixup : result.solution.fixups)
    add_row(table, "{},{},{},{},{},{},{},{},{},{}", fixup.ordinate, fixup.direction[0], fixup.direction[1],
            fixup.direction[2], fixup.weight, csv_field(bands[static_cast<std::size_t>(fixup.band)]),
            fixup.cells, fixup.failed, fixup.smallest, fixup.moved);
  return table;
}

std::string history_csv(const RunResult& result) {
  const std::vector<std::string>& bands = result.problem.bands().names;
  std::string table = "sweep,band,residual\n";
  for (const HistoryEntry& entry : result.solution.history)
    add_row(table, "{},{},{}", entry.sweep, csv_field(bands[static_cast<std::size_t>(entry.band)]),
            entry.residual);
  return table;
}

}  // namespace etendue
