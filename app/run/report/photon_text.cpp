// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/report/photon_text.h"

#include <fmt/format.h>

#include "app/run/report/report_parts.h"
#include "app/write/result/unit_labels.h"

namespace etendue {
namespace {

std::string percent(double part, double whole) {
  return whole != 0 ? fmt::format("{:.2g}", 100 * part / whole) : "";
}

}  // namespace

std::string photons_text(const RunResult& result) {
  if (!result.errors) return "";
  const RunErrors& errors = *result.errors;
  const PhotonReport& report = errors.report;
  std::string text;
  for (const std::string& note : result.solution.notes) text += "  " + note + "\n";
  TextTable table({"band", "error [%]", "median of cells [%]", "figure of merit [1/s]"},
                  {Align::left, Align::right, Align::right, Align::right});
  for (std::size_t b = 0; b < report.error.size(); ++b)
    table.add_row({result.problem.bands().names[b], fmt::format("{:.3g}", 100 * report.error[b]),
                   fmt::format("{:.3g}", 100 * report.cell_error[b]),
                   fmt::format("{:.3g}", report.figure[b])});
  text += titled(fmt::format("photons: {:.6g} histories in each band; relative standard error of the fluence",
                             errors.histories),
                 table);
  if (report.seconds > 0)
    text += fmt::format(
        "  {:.3g} photons and {:.3g} steps a millisecond of processor time; {:.3g} steps and {:.3g} "
        "collisions a "
        "photon\n",
        1e-3 * report.histories / report.seconds, 1e-3 * report.segments / report.seconds,
        report.segments / report.histories, report.collisions / report.histories);
  return text;
}

std::string errors_text(const RunResult& result) {
  if (!result.errors) return "";
  const RunErrors& errors = *result.errors;
  const auto& bands = result.problem.bands().names;
  TextTable table({"", "band", "quantity", "standard error", "%"},
                  {Align::left, Align::left, Align::left, Align::right, Align::right});
  std::size_t rows = 0;
  const UnitLabels units(result.input.units);
  const auto add = [&](const std::string& name, std::size_t b, const std::string& what, double error,
                       double value) {
    const std::string& unit = what == "fluence" ? units.flux : units.power;
    table.add_row({name, bands[b], fmt::format("{} [{}]", what, unit), fmt::format("{:.2g}", error),
                   percent(error, value)});
    ++rows;
  };
  for (std::size_t b = 0; b < bands.size(); ++b) {
    add("balance", b, "absorbed", errors.balances[b].absorbed, result.balances[b].absorbed);
    add("balance", b, "outflow", errors.balances[b].outflow, result.balances[b].outflow);
  }
  for (std::size_t w = 0; w < result.walls.size(); ++w)
    for (std::size_t b = 0; b < bands.size(); ++b)
      add(result.problem.walls()[w].name, b, "incoming", errors.walls[w][b].incoming,
          result.walls[w][b].incoming);
  for (std::size_t r = 0; r < result.regions.size(); ++r)
    for (std::size_t b = 0; b < bands.size(); ++b)
      add(result.problem.media()[r].name, b, "fluence", errors.regions[r][b].fluence_mean,
          result.regions[r][b].fluence_mean);
  for (const ProbeRow& row : result.probes)
    for (std::size_t b = 0; b < bands.size() && row.errors; ++b)
      add(fmt::format("{} {}", row.name, row.index), b, "fluence", row.errors->values[b].fluence,
          row.values[b].fluence);
  const std::string unreached =
      errors.unreached_probes == 0
          ? ""
          : fmt::format(
                "  values of probes that no history reached: {}; the error is an upper bound there, three "
                "histories' worth\n",
                errors.unreached_probes);
  if (rows > longest_report_table) return "\nstandard errors: many, see the tables\n" + unreached;
  return titled("standard errors", table) + unreached;
}

}  // namespace etendue
