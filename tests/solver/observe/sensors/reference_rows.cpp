// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/solver/observe/sensors/reference_rows.h"
#include "tests/support/checkout.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

namespace etendue::test {
namespace {

std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < text.size();) {
    const bool begins = std::isdigit(static_cast<unsigned char>(text[i])) != 0;
    if (!begins) {
      ++i;
      continue;
    }
    std::size_t used = 0;
    numbers.push_back(std::stod(text.substr(i), &used));
    i += used;
  }
  return numbers;
}

}  // namespace

std::vector<ReferenceRow> reference_rows(const std::string& file) {
  std::ifstream stream(checkout("validation/reference/" + file));
  std::vector<ReferenceRow> rows;
  for (std::string line; std::getline(stream, line);) {
    const std::size_t open = line.find('"'), close = line.rfind('"');
    if (line.starts_with('#') || open == std::string::npos) continue;
    std::string values = line.substr(close + 1);
    std::replace(values.begin(), values.end(), ',', ' ');
    ReferenceRow row{line.substr(0, open - 1), numbers_in(line.substr(open, close - open)), {}};
    std::istringstream numbers(values);
    for (double value = 0; numbers >> value;) row.values.push_back(value);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace etendue::test
