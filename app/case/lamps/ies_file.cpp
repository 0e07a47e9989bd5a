// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/lamps/ies_file.h"

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

/// Files of many programs do not keep to the capitals of LM-63.
std::string upper_case(std::string text) {
  for (char& letter : text)
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  return text;
}

/// The words of a file after its TILT line with the lines they stand on; commas part them too.
class IesNumbers {
 public:
  IesNumbers(std::istream& stream, const std::filesystem::path& path) : stream_(stream), path_(path) {}

  /// Reads up to the line TILT=...; returns the text after the sign.
  std::string skip_to_tilt() {
    std::string line;
    while (next_line(line)) {
      if (!upper_case(line).starts_with("TILT=")) continue;
      std::string what(trimmed(line.substr(5)));
      if (what.empty()) refuse("\"TILT=\" says nothing; give TILT=NONE, TILT=INCLUDE or the name of a file");
      return what;
    }
    refuse("has no line TILT= (the numbers of an IES file come after it); give an IES file of LM-63");
  }

  double next(const char* what) {
    while (at_ == line_.size() || separates(line_[at_])) {
      if (at_ < line_.size()) {
        ++at_;
      } else if (!next_line(line_)) {
        refuse(fmt::format("ends before {}", what));
      } else {
        at_ = 0;
      }
    }
    const char* begin = line_.c_str() + at_;
    char* end = nullptr;
    const double value = std::strtod(begin, &end);
    if (end == begin || !std::isfinite(value) || (*end != '\0' && !separates(*end)))
      refuse(fmt::format("\"{}\" is not a number, where {} should stand", word(), what));
    at_ += static_cast<std::size_t>(end - begin);
    return value;
  }
  std::vector<double> next(std::size_t count, const char* what) {
    std::vector<double> values(count);
    for (double& value : values) value = next(what);
    return values;
  }
  std::size_t next_count(const char* what) {
    const double value = next(what);
    if (!(value >= 1 && value <= most_lamp_angles) || value != std::floor(value))
      refuse(fmt::format("{} is no number of angles, where {} should stand", value, what));
    return static_cast<std::size_t>(value);
  }
  [[noreturn]] void refuse(const std::string& problem) const {
    throw InputError(fault_at({path_.string(), number_, ""}, "", problem));
  }

 private:
  static bool separates(char c) { return c == ' ' || c == '\t' || c == ',' || c == '\r'; }
  std::string word() const {
    std::size_t end = at_;
    while (end < line_.size() && !separates(line_[end])) ++end;
    return line_.substr(at_, end - at_);
  }
  bool next_line(std::string& line) {
    if (!std::getline(stream_, line)) return false;
    ++number_;
    while (!line.empty() && line.back() == '\r') line.pop_back();
    return true;
  }

  std::istream& stream_;
  const std::filesystem::path& path_;
  std::string line_;
  std::size_t at_ = 0;
  int number_ = 0;
};

/// Planes all around, from the first to one turn beyond it.
void complete_turn_by_range(IesNumbers& numbers, std::vector<double>& angles, LampPlanes& planes) {
  const double first = angles.front(), last = angles.back();
  if (first == 0 && last == 90) {
    mirror_planes(90, angles, planes);
    mirror_planes(180, angles, planes);
  } else if (first == 0 && last == 180) {
    mirror_planes(180, angles, planes);
  } else if (first == 90 && last == 270) {
    mirror_planes(270, angles, planes);
  } else if (first == 0 && last > 180 && last < 360) {
    angles.push_back(360);
    planes.push_back(planes.front());
  } else if (first != 0 || last != 360) {
    numbers.refuse(
        fmt::format("horizontal angles of type C from {} to {} are no part of a turn that LM-63 knows; "
                    "give 0, 0 to 90, 0 to 180, 90 to 270 or 0 to 360 degrees",
                    first, last));
  }
}

/// Planes to both sides of the middle one.
void complete_half_turn(IesNumbers& numbers, std::vector<double>& angles, LampPlanes& planes) {
  if (angles.front() == -90 && angles.back() == 90) return;
  if (angles.front() != 0 || angles.back() != 90)
    numbers.refuse(
        fmt::format("horizontal angles of type A or B from {} to {}; give 0 to 90 or -90 to 90 degrees",
                    angles.front(), angles.back()));
  for (std::size_t i = 1, count = angles.size(); i < count; ++i) {
    angles.insert(angles.begin(), -angles[2 * i - 1]);
    planes.insert(planes.begin(), LampPlanes::value_type(planes[2 * i - 1]));
  }
}

void require_rising(IesNumbers& numbers, const std::vector<double>& angles, const char* which) {
  for (std::size_t i = 1; i < angles.size(); ++i)
    if (!(angles[i] > angles[i - 1]))
      numbers.refuse(
          fmt::format("the {} angle {} comes after {}; they must rise", which, angles[i], angles[i - 1]));
}

// LM-63-02, section 5: the position of the lamp in the luminaire, the number of pairs, angles and factors.
// In geometry 1 the lamp stands along the axis of the luminaire, in 2 and 3 across it.
LampTilt read_factors(IesNumbers& numbers) {
  const double geometry = numbers.next("the lamp-to-luminaire geometry");
  if (geometry != 1 && geometry != 2 && geometry != 3)
    numbers.refuse(fmt::format("{} is no lamp-to-luminaire geometry; give 1, 2 or 3", geometry));
  const std::size_t count = numbers.next_count("the number of tilt angles");
  LampTilt tilt;
  tilt.lies_across = geometry != 1;
  tilt.angle = numbers.next(count, "the tilt angles");
  require_rising(numbers, tilt.angle, "tilt");
  if (tilt.angle.front() < 0 || tilt.angle.back() > 180)
    numbers.refuse(fmt::format("tilt angles from {} to {}; give 0 to 180 degrees at most", tilt.angle.front(),
                               tilt.angle.back()));
  for (std::size_t i = 0; i < count; ++i) {
    tilt.factor.push_back(numbers.next("the tilt factors"));
    if (tilt.factor.back() < 0)
      numbers.refuse(fmt::format("the tilt factor {} is negative", tilt.factor.back()));
  }
  return tilt;
}

/// `what` is NONE or INCLUDE, in letters of any case, or the name of a file beside the lamp's.
LampTilt read_tilt(IesNumbers& numbers, const std::string& what, const std::filesystem::path& path) {
  if (upper_case(what) == "NONE") return {};
  if (upper_case(what) == "INCLUDE") return read_factors(numbers);
  const std::filesystem::path file = path.parent_path() / what;
  std::ifstream stream(file);
  if (!stream) numbers.refuse(fmt::format("the file {} of TILT={} cannot be read", file.string(), what));
  IesNumbers factors(stream, file);
  return read_factors(factors);
}

}  // namespace

// LM-63-02, section 5: lamps, lumens, multiplier, numbers of vertical and horizontal angles, photometric type
// (1 C, 2 B, 3 A), units, three dimensions, ballast factors and watts; the angles; the candelas of each
// horizontal angle.
LightTable read_ies(std::istream& stream, const std::filesystem::path& path) {
  IesNumbers numbers(stream, path);
  const LampTilt tilt = read_tilt(numbers, numbers.skip_to_tilt(), path);
  const double multiplier = numbers.next(3, "the lamps").back();
  const std::size_t vertical = numbers.next_count("the number of vertical angles"),
                    horizontal = numbers.next_count("the number of horizontal angles");
  const double type = numbers.next("the photometric type");
  if (type != 1 && type != 2 && type != 3)
    numbers.refuse(fmt::format("{} is no photometric type; give 1 (C), 2 (B) or 3 (A)", type));
  const std::vector<double> rest = numbers.next(7, "the angles");
  LightTable table;
  table.tilt = tilt;
  // Files without photometric factors have a shape only.
  if (const double factor = multiplier * rest[4] * rest[5]; factor > 0) table.candelas = factor;
  table.type = type == 1 ? PhotometricType::c : type == 2 ? PhotometricType::b : PhotometricType::a;
  table.angle = numbers.next(vertical, "the vertical angles");
  require_rising(numbers, table.angle, "vertical");
  if (table.type != PhotometricType::c && (table.angle.front() != -90 || table.angle.back() != 90))
    numbers.refuse(fmt::format("vertical angles of type A or B from {} to {}; give -90 to 90 degrees",
                               table.angle.front(), table.angle.back()));
  table.plane = numbers.next(horizontal, "the horizontal angles");
  require_rising(numbers, table.plane, "horizontal");
  LampPlanes planes;
  for (std::size_t plane = 0; plane < horizontal; ++plane) {
    planes.push_back(numbers.next(vertical, "the candelas"));
    for (const double candela : planes.back())
      if (candela < 0) numbers.refuse(fmt::format("the intensity {} is negative", candela));
  }
  if (table.type != PhotometricType::c) {
    complete_half_turn(numbers, table.plane, planes);
    for (double& angle : table.angle) angle += 90;
  } else if (horizontal == 1 || all_alike(planes)) {
    table.plane.clear();
    planes.resize(1);
  } else {
    complete_turn_by_range(numbers, table.plane, planes);
  }
  for (const std::vector<double>& plane : planes)
    table.intensity.insert(table.intensity.end(), plane.begin(), plane.end());
  return table;
}

}  // namespace etendue
