// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/app/readings/sensor_table.h"

#include "tests/app/run/csv_table.h"

namespace etendue::test {

std::map<std::string, std::vector<double>> rows_of(const std::string& table) {
  std::map<std::string, std::vector<double>> rows;
  for (const std::vector<std::string>& fields : CsvTable(table).rows())
    for (std::size_t i = 3; i < 6; ++i)
      rows[fields.at(0) + " " + fields.at(1) + " " + fields.at(2) + " " + fields.at(6)].push_back(
          std::stod(fields.at(i)));
  return rows;
}

}  // namespace etendue::test
