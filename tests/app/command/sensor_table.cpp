// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/app/command/sensor_table.h"

#include <sstream>

namespace etendue::test {

std::map<std::string, std::vector<double>> rows_of(const std::string& table) {
  std::map<std::string, std::vector<double>> rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> fields;
    std::istringstream parts(line);
    for (std::string field; std::getline(parts, field, ',');) fields.push_back(field);
    if (fields[0] == "sensor") continue;
    for (std::size_t i = 3; i < 6; ++i)
      rows[fields[0] + " " + fields[1] + " " + fields[2] + " " + fields[6]].push_back(std::stod(fields[i]));
  }
  return rows;
}

}  // namespace etendue::test
