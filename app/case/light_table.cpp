// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/light_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "app/case/ies_file.h"
#include "app/case/number_columns.h"

namespace etendue {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& problem) {
  throw InputError(fault_at({path.string(), 0, ""}, "", problem));
}

void check(const LightTable& table, const std::filesystem::path& path) {
  if (table.angle.size() < 2) refuse(path, "has fewer than two angles; give some from 0 to 180 degrees");
  for (std::size_t i = 0; i < table.angle.size(); ++i) {
    const bool rises = i == 0 || table.angle[i] > table.angle[i - 1];
    if (!rises || table.angle[i] < 0 || table.angle[i] > 180)
      refuse(path,
             fmt::format("angle {} is out of order; give them rising from 0 to 180 degrees", table.angle[i]));
  }
  for (std::size_t i = 0; i < table.intensity.size(); ++i)
    if (!(table.intensity[i] >= 0) || !std::isfinite(table.intensity[i]))
      refuse(path, fmt::format("the intensity at {} degrees is not a number of at least 0",
                               table.angle[i % table.angle.size()]));
  if (*std::max_element(table.intensity.begin(), table.intensity.end()) == 0) refuse(path, "is dark");
}

}  // namespace

LightTable read_light_table(const std::filesystem::path& path, const Origin& origin) {
  LightTable table;
  if (path.extension() == ".ies" || path.extension() == ".IES") {
    std::ifstream stream(path);
    if (!stream) throw FileError(path.string(), "cannot be read (" + origin.key + ")");
    table = read_ies(stream, path);
  } else {
    const auto columns = read_columns(path, {"angle", "intensity"});
    table.angle = columns[0];
    table.intensity = columns[1];
  }
  check(table, path);
  return table;
}

}  // namespace etendue
