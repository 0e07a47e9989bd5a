// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/lamps/ldt_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>

#include "app/case/lamps/lamp_planes.h"
#include "base/errors.h"
#include "base/text/trimmed.h"

namespace etendue {
namespace {

/// Intensities are given in cd for this flux of the lamps [lm].
constexpr double reference_flux = 1000;

/// The lines of a file, one value each.
class LdtLines {
 public:
  explicit LdtLines(const std::filesystem::path& path) : stream_(path), path_(path) {
    if (!stream_) throw FileError(path.string(), "cannot be read");
  }

  void skip(int count, const char* what) {
    for (int i = 0; i < count; ++i) next_line(what);
  }

  double number(const char* what) {
    std::string text = next_line(what);
    std::ranges::replace(text, ',', '.');  // as some European programs write it
    const std::string word(trimmed(text));
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !std::isfinite(value))
      refuse(fmt::format("\"{}\" is not a number, where {} should stand", word, what));
    return value;
  }

  std::vector<double> numbers(int count, const char* what) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(number(what));
    return values;
  }

  int count(const char* what, int least, int most) {
    const double value = number(what);
    if (value != std::floor(value) || value < least || value > most)
      refuse(fmt::format("{} is no count, where {} should stand; give {} to {}", value, what, least, most));
    return static_cast<int>(value);
  }

  /// Numbers that rise from line to line.
  std::vector<double> rising(int count, const char* what) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
      values.push_back(number(what));
      if (i > 0 && values[values.size() - 1] <= values[values.size() - 2])
        refuse(fmt::format("{} comes after {} in {}; they must rise", values.back(),
                           values[values.size() - 2], what));
    }
    return values;
  }

  [[noreturn]] void refuse(const std::string& problem) const {
    throw InputError(fault_at({path_.string(), number_, ""}, "", problem));
  }

 private:
  std::string next_line(const char* what) {
    std::string line;
    if (!std::getline(stream_, line)) refuse(fmt::format("ends before {}", what));
    ++number_;
    while (!line.empty() && line.back() == '\r') line.pop_back();
    return line;
  }

  std::ifstream stream_;
  const std::filesystem::path& path_;
  int number_ = 0;
};

/// Which planes a file holds, by its symmetry: the first, and how many.
struct StoredPlanes {
  int first;
  int count;
};

StoredPlanes stored_planes(LdtLines& lines, int symmetry, int planes) {
  const int part = symmetry == 4 || symmetry == 3 ? 4 : symmetry == 2 ? 2 : 1;
  if (planes % part != 0)
    lines.refuse(fmt::format("{} planes cannot have the symmetry {}; their number must be a multiple of {}",
                             planes, symmetry, part));
  switch (symmetry) {
    case 1:
      return {0, 1};
    case 2:
      return {0, planes / 2 + 1};
    case 3:
      return {3 * planes / 4, planes / 2 + 1};
    case 4:
      return {0, planes / 4 + 1};
    default:
      return {0, planes};
  }
}

/// Angles of the stored planes [degree]; those before plane 0 are negative.
std::vector<double> stored_angles(LdtLines& lines, const std::vector<double>& all, const StoredPlanes& stored,
                                  int symmetry) {
  std::vector<double> angles;
  for (int i = stored.first; i < stored.first + stored.count; ++i) {
    const double angle = all[static_cast<std::size_t>(i) % all.size()];
    angles.push_back(symmetry == 3 && i < static_cast<int>(all.size()) ? angle - 360 : angle);
  }
  const double first = symmetry == 3 ? -90 : 0, last = symmetry == 2 ? 180 : 90;
  if (symmetry >= 2 && (angles.front() != first || angles.back() != last))
    lines.refuse(fmt::format("planes of the symmetry {} from {} to {} degrees; they must go from {} to {}",
                             symmetry, angles.front(), angles.back(), first, last));
  if (symmetry == 0 && (angles.front() != 0 || angles.back() >= 360))
    lines.refuse(fmt::format("planes from {} to {} degrees; they must go from 0 to below 360", angles.front(),
                             angles.back()));
  return angles;
}

/// Planes all around, from the first to one turn beyond it.
void complete_by_symmetry(int symmetry, std::vector<double>& angles, LampPlanes& planes) {
  if (symmetry == 0) {
    angles.push_back(360);
    planes.push_back(LampPlanes::value_type(planes.front()));
  }
  if (symmetry == 3 || symmetry == 4) mirror_planes(90, angles, planes);
  if (symmetry == 2 || symmetry == 4) mirror_planes(180, angles, planes);
}

}  // namespace

// Lines 1 to 26; six of each set of lamps; ten direct ratios; the planes C; the angles gamma from straight
// down; the intensities of each stored plane in cd per 1000 lm of the first set of lamps.
LightTable read_ldt(const std::filesystem::path& path) {
  LdtLines lines(path);
  lines.skip(2, "the symmetry");
  const int symmetry = lines.count("the symmetry", 0, 4);
  const int plane_count = lines.count("the number of planes", 1, most_lamp_angles);
  const StoredPlanes stored = stored_planes(lines, symmetry, plane_count);
  lines.skip(1, "the number of angles");
  const int angle_count = lines.count("the number of angles", 2, most_lamp_angles);
  lines.skip(17, "the conversion factor");
  const double conversion = lines.number("the conversion factor");
  if (!(conversion > 0))
    lines.refuse(fmt::format("the conversion factor {} leaves no light; give one above 0", conversion));
  lines.skip(1, "the number of sets of lamps");
  const int sets = lines.count("the number of sets of lamps", 1, most_lamp_angles);
  lines.skip(2, "the flux of the lamps");
  const double flux = lines.number("the flux of the lamps");
  if (flux < 0) lines.refuse(fmt::format("the flux {} of the lamps is negative", flux));
  lines.skip(3 + 6 * (sets - 1) + 10, "the planes");

  LightTable table;
  // Files without a flux have a shape only.
  if (flux > 0) table.candelas = conversion * flux / reference_flux;
  const std::vector<double> all = lines.rising(plane_count, "the planes");
  table.plane = stored_angles(lines, all, stored, symmetry);
  table.angle = lines.rising(angle_count, "the angles");
  LampPlanes planes;
  for (int plane = 0; plane < stored.count; ++plane) {
    std::vector<double>& values = planes.emplace_back();
    for (int i = 0; i < angle_count; ++i) {
      values.push_back(lines.number("the intensities"));
      if (values.back() < 0) lines.refuse(fmt::format("the intensity {} is negative", values.back()));
    }
  }
  if (all_alike(planes)) {
    table.plane.clear();
    planes.resize(1);
  } else {
    complete_by_symmetry(symmetry, table.plane, planes);
  }
  for (const std::vector<double>& plane : planes)
    table.intensity.insert(table.intensity.end(), plane.begin(), plane.end());
  return table;
}

}  // namespace etendue
