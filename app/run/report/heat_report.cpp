// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include "app/case/temperatures.h"
#include "app/progress/text_table.h"
#include "app/run/report/run_report.h"
#include "app/write/result/heat_rows.h"

namespace etendue {
namespace {

/// Rows beyond which the table is left to heat.csv.
constexpr std::size_t longest_table = 40;

void add(TextTable& table, const HeatRow& row) {
  table.add_row({row.name, number(row.extent), number(row.emitted), number(row.absorbed),
                 number(row.net, row.error),
                 number(row.density(), row.extent > 0 ? row.error / row.extent : 0)});
}

TextTable table_of(const char* kind, const char* extent, const char* net, const char* density) {
  return TextTable({kind, extent, "emitted [W]", "absorbed [W]", net, density},
                   {Align::left, Align::right, Align::right, Align::right, Align::right, Align::right});
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
  return fmt::format("\nradiative heat\n{}{}  {:.6g} W leave the media and {:.6g} W enter the walls\n",
                     walls.text(), regions.text(), out_of_regions, into_walls);
}

}  // namespace etendue
