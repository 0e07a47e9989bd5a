// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/light_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "app/case/number_columns.h"

namespace etendue {
namespace {

/// Planes of a lamp that differ by less than this part of its largest intensity are measured alike.
constexpr double alike = 0.02;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& problem) {
  throw InputError(fault_at({path.string(), 0, ""}, "", problem));
}

/// The numbers of an IES file after its TILT line, in their order whatever the line breaks.
class IesNumbers {
 public:
  IesNumbers(std::istream& stream, const std::filesystem::path& path) : stream_(stream), path_(path) {}

  double next(const char* what) {
    double value = 0;
    if (!(stream_ >> value) || !std::isfinite(value))
      refuse(path_,
             fmt::format("ends before {} (an IES file has its numbers after the line TILT=NONE)", what));
    return value;
  }
  std::vector<double> next(std::size_t count, const char* what) {
    std::vector<double> values(count);
    for (double& value : values) value = next(what);
    return values;
  }

 private:
  std::istream& stream_;
  const std::filesystem::path& path_;
};

// IESNA LM-63-2002, section 5: lamps, lumens, multiplier, vertical and horizontal angles, photometric type,
// units, three dimensions, ballast factors and watts; the angles; the candelas of each horizontal plane.
LightTable read_ies(std::istream& stream, const std::filesystem::path& path) {
  std::string line;
  while (std::getline(stream, line) && !line.starts_with("TILT=")) {
  }
  if (!line.starts_with("TILT=NONE"))
    refuse(path, "has no line TILT=NONE (a lamp that is tilted is not in this version); give another file");
  IesNumbers numbers(stream, path);
  numbers.next(3, "the lamps");
  const double vertical = numbers.next("the vertical angles"),
               horizontal = numbers.next("the horizontal angles");
  if (!(vertical >= 1 && vertical < 1e5 && horizontal >= 1 && horizontal < 1e5))
    refuse(path, "has no sound number of angles");
  if (numbers.next("the photometric type") != 1)
    refuse(path, "is not of photometric type C (others are not in this version)");
  numbers.next(7, "the angles");
  LightTable table;
  table.angle = numbers.next(static_cast<std::size_t>(vertical), "the vertical angles");
  const auto planes = static_cast<std::size_t>(horizontal);
  numbers.next(planes, "the horizontal angles");
  table.intensity.assign(table.angle.size(), 0);
  std::vector<double> first;
  double largest = 0, spread = 0;
  for (std::size_t plane = 0; plane < planes; ++plane) {
    const std::vector<double> values = numbers.next(table.angle.size(), "the candelas");
    if (plane == 0) first = values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      table.intensity[i] += values[i] / static_cast<double>(planes);
      largest = std::max(largest, values[i]);
      spread = std::max(spread, std::abs(values[i] - first[i]));
    }
  }
  if (spread > alike * largest)
    refuse(path, "does not shine alike all about its axis (not in this version); give a lamp that does");
  return table;
}

void check(const LightTable& table, const std::filesystem::path& path) {
  if (table.angle.size() < 2) refuse(path, "has fewer than two angles; give some from 0 to 180 degrees");
  for (std::size_t i = 0; i < table.angle.size(); ++i) {
    const bool rises = i == 0 || table.angle[i] > table.angle[i - 1];
    if (!rises || table.angle[i] < 0 || table.angle[i] > 180)
      refuse(path,
             fmt::format("angle {} is out of order; give them rising from 0 to 180 degrees", table.angle[i]));
    if (!(table.intensity[i] >= 0) || !std::isfinite(table.intensity[i]))
      refuse(path, fmt::format("the intensity at {} degrees is not a number of at least 0", table.angle[i]));
  }
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
    table = {columns[0], columns[1]};
  }
  check(table, path);
  return table;
}

}  // namespace etendue
