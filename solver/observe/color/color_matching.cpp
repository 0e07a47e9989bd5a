// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/color/color_matching.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace etendue {

extern const char* const cie1931_table;

namespace {

struct Row {
  double wavelength = 0;
  std::array<double, 3> value{};
};

std::vector<Row> read_table() {
  std::vector<Row> rows;
  std::istringstream stream(cie1931_table);
  for (std::string line; std::getline(stream, line);) {
    std::replace(line.begin(), line.end(), ',', ' ');
    Row row;
    std::istringstream(line) >> row.wavelength >> row.value[0] >> row.value[1] >> row.value[2];
    // Comments and the header do not begin with a number.
    if (row.wavelength > 0) rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::array<double, 3> mean_color_matching(double from, double to) {
  static const std::vector<Row> table = read_table();
  if (from > to) std::swap(from, to);
  std::array<double, 3> integral{};
  for (std::size_t i = 0; i + 1 < table.size(); ++i) {
    const Row &a = table[i], &b = table[i + 1];
    const double low = std::max(from, a.wavelength), high = std::min(to, b.wavelength);
    if (low >= high) continue;
    const double middle = ((low + high) / 2 - a.wavelength) / (b.wavelength - a.wavelength);
    for (std::size_t k = 0; k < 3; ++k)
      integral[k] += (high - low) * (a.value[k] + middle * (b.value[k] - a.value[k]));
  }
  for (double& value : integral) value /= to - from;
  return integral;
}

}  // namespace etendue
