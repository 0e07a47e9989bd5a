// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/lamps/light_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <utility>

#include "app/case/lamps/ies_file.h"
#include "app/case/lamps/ldt_file.h"
#include "base/errors.h"
#include "base/text/number_columns.h"
#include "base/text/text_lines.h"

namespace etendue {
namespace {

[[noreturn]] void refuse_table(const std::filesystem::path& path, const std::string& problem) {
  throw InputError(fault_at({path.string(), 0, ""}, "", problem));
}

void check(const LightTable& table, const std::filesystem::path& path) {
  if (table.angle.size() < 2)
    refuse_table(path, "has fewer than two angles; give some from 0 to 180 degrees");
  for (std::size_t i = 0; i < table.angle.size(); ++i) {
    const bool rises = i == 0 || table.angle[i] > table.angle[i - 1];
    if (!rises || table.angle[i] < 0 || table.angle[i] > 180)
      refuse_table(path, fmt::format("angle {} is out of order; give them rising from 0 to 180 degrees",
                                     table.angle[i]));
  }
  for (std::size_t i = 0; i < table.intensity.size(); ++i)
    if (!(table.intensity[i] >= 0) || !std::isfinite(table.intensity[i]))
      refuse_table(path, fmt::format("the intensity at {} degrees is not a number of at least 0",
                                     table.angle[i % table.angle.size()]));
  if (*std::max_element(table.intensity.begin(), table.intensity.end()) == 0) refuse_table(path, "is dark");
}

/// How many values stand on the first line that has any.
std::size_t columns_of(const std::filesystem::path& path) {
  TextLines lines(path, '#');
  if (!lines.next()) refuse_table(path, "is empty; give an angle and an intensity on each line");
  return 1 + static_cast<std::size_t>(std::ranges::count(lines.rest(), ','));
}

std::vector<double> different(std::vector<double> values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

// Lines in any order, one for each pair of an angle and an azimuth; azimuth 360 may be left out.
LightTable read_grid(const std::filesystem::path& path) {
  const auto columns = read_columns(path, {"angle", "azimuth", "intensity"});
  LightTable table;
  table.angle = different(columns[0]);
  table.plane = different(columns[1]);
  if (table.plane.empty() || table.plane.front() != 0 || table.plane.back() > 360)
    refuse_table(path, "has azimuths that do not go from 0 to 360 degrees at most; give those");
  std::map<std::pair<double, double>, double> values;
  for (std::size_t i = 0; i < columns[0].size(); ++i)
    if (!values.emplace(std::pair(columns[1][i], columns[0][i]), columns[2][i]).second)
      refuse_table(path,
                   fmt::format("has the angle {} at the azimuth {} twice", columns[0][i], columns[1][i]));
  if (values.size() != table.angle.size() * table.plane.size())
    refuse_table(path, fmt::format("has {} lines for {} angles and {} azimuths; give one for each pair",
                                   values.size(), table.angle.size(), table.plane.size()));
  for (const auto& [place, value] : values) table.intensity.push_back(value);
  if (table.plane.size() == 1) {
    table.plane.clear();
  } else if (table.plane.back() < 360) {
    table.plane.push_back(360);
    const std::vector<double> first(
        table.intensity.begin(), table.intensity.begin() + static_cast<std::ptrdiff_t>(table.angle.size()));
    table.intensity.insert(table.intensity.end(), first.begin(), first.end());
  }
  return table;
}

}  // namespace

LightTable read_light_table(const std::filesystem::path& path) {
  LightTable table;
  std::string kind = path.extension().string();
  std::ranges::transform(kind, kind.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (kind == ".ldt") {
    table = read_ldt(path);
  } else if (kind == ".ies") {
    std::ifstream stream(path);
    table = read_ies(stream, path);
  } else if (columns_of(path) == 3) {
    table = read_grid(path);
  } else {
    const auto columns = read_columns(path, {"angle", "intensity"});
    table.angle = columns[0];
    table.intensity = columns[1];
  }
  check(table, path);
  return table;
}

}  // namespace etendue
