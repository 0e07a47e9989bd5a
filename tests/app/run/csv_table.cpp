// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/app/run/csv_table.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace etendue::test {
namespace {

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream parts(line);
  for (std::string field; std::getline(parts, field, ',');) fields.push_back(field);
  return fields;
}

}  // namespace

CsvTable::CsvTable(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  names_ = fields_of(line);
  while (std::getline(lines, line)) rows_.push_back(fields_of(line));
}

std::size_t CsvTable::index_of(const std::string& name) const {
  const auto found = std::ranges::find(names_, name);
  if (found == names_.end()) throw std::out_of_range("no column " + name);
  return static_cast<std::size_t>(found - names_.begin());
}

std::vector<std::string> CsvTable::column(const std::string& name) const {
  std::vector<std::string> fields;
  for (const std::vector<std::string>& row : rows_) fields.push_back(row.at(index_of(name)));
  return fields;
}

std::vector<double> CsvTable::numbers(const std::string& name) const {
  std::vector<double> numbers;
  for (const std::string& field : column(name)) numbers.push_back(std::stod(field));
  return numbers;
}

double CsvTable::number(const std::vector<std::string>& beginning, const std::string& name) const {
  for (const std::vector<std::string>& row : rows_)
    if (row.size() >= beginning.size() && std::equal(beginning.begin(), beginning.end(), row.begin()))
      return std::stod(row.at(index_of(name)));
  throw std::out_of_range("no row of " + beginning.front());
}

}  // namespace etendue::test
