// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/ies_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace etendue {
namespace {

/// Planes that differ by less than this part of the largest intensity are measured alike.
constexpr double alike = 1e-9;
/// More angles than any lamp has.
constexpr double most_angles = 1e5;

/// The words of a file after its TILT line with the lines they stand on; commas part them too.
class IesNumbers {
 public:
  IesNumbers(std::istream& stream, const std::filesystem::path& path) : stream_(stream), path_(path) {}

  /// Reads up to the line TILT=NONE.
  void skip_to_tilt() {
    std::string line;
    while (next_line(line)) {
      if (!line.starts_with("TILT=")) continue;
      if (line.starts_with("TILT=NONE")) return;
      refuse(
          fmt::format("\"{}\" is not in this version (a lamp whose light changes as it is tilted); give a "
                      "file with TILT=NONE",
                      line));
    }
    refuse("has no line TILT=NONE (the numbers of an IES file come after it); give an IES file of LM-63");
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
    if (!(value >= 1 && value < most_angles) || value != std::floor(value))
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

using Planes = std::vector<std::vector<double>>;

/// Adds the planes 2 about - p for those p that differ from `about`: the lamp is symmetric there.
void mirror(double about, std::vector<double>& angles, Planes& planes) {
  for (std::size_t i = angles.size(); i-- > 0;)
    if (angles[i] < about) {
      angles.push_back(2 * about - angles[i]);
      planes.push_back(planes[i]);
    }
}

/// Planes all around, from the first to one turn beyond it.
void complete_turn(IesNumbers& numbers, std::vector<double>& angles, Planes& planes) {
  const double first = angles.front(), last = angles.back();
  if (first == 0 && last == 90) {
    mirror(90, angles, planes);
    mirror(180, angles, planes);
  } else if (first == 0 && last == 180) {
    mirror(180, angles, planes);
  } else if (first == 90 && last == 270) {
    mirror(270, angles, planes);
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
void complete_half_turn(IesNumbers& numbers, std::vector<double>& angles, Planes& planes) {
  if (angles.front() == -90 && angles.back() == 90) return;
  if (angles.front() != 0 || angles.back() != 90)
    numbers.refuse(
        fmt::format("horizontal angles of type A or B from {} to {}; give 0 to 90 or -90 to 90 degrees",
                    angles.front(), angles.back()));
  for (std::size_t i = 1, count = angles.size(); i < count; ++i) {
    angles.insert(angles.begin(), -angles[2 * i - 1]);
    planes.insert(planes.begin(), Planes::value_type(planes[2 * i - 1]));
  }
}

bool all_alike(const Planes& planes) {
  double largest = 0, spread = 0;
  for (const std::vector<double>& plane : planes)
    for (std::size_t i = 0; i < plane.size(); ++i) {
      largest = std::max(largest, plane[i]);
      spread = std::max(spread, std::abs(plane[i] - planes.front()[i]));
    }
  return spread <= alike * largest;
}

void require_rising(IesNumbers& numbers, const std::vector<double>& angles, const char* which) {
  for (std::size_t i = 1; i < angles.size(); ++i)
    if (!(angles[i] > angles[i - 1]))
      numbers.refuse(
          fmt::format("the {} angle {} comes after {}; they must rise", which, angles[i], angles[i - 1]));
}

}  // namespace

// LM-63-02, section 5: lamps, lumens, multiplier, numbers of vertical and horizontal angles, photometric type
// (1 C, 2 B, 3 A), units, three dimensions, ballast factors and watts; the angles; the candelas of each
// horizontal angle.
LightTable read_ies(std::istream& stream, const std::filesystem::path& path) {
  IesNumbers numbers(stream, path);
  numbers.skip_to_tilt();
  const double multiplier = numbers.next(3, "the lamps").back();
  const std::size_t vertical = numbers.next_count("the number of vertical angles"),
                    horizontal = numbers.next_count("the number of horizontal angles");
  const double type = numbers.next("the photometric type");
  if (type != 1 && type != 2 && type != 3)
    numbers.refuse(fmt::format("{} is no photometric type; give 1 (C), 2 (B) or 3 (A)", type));
  const std::vector<double> rest = numbers.next(7, "the angles");
  LightTable table;
  table.candelas = multiplier * rest[4] * rest[5];
  if (!(*table.candelas > 0))
    numbers.refuse(fmt::format(
        "the multiplier {} and the ballast factors {} and {} leave no light; give factors above 0",
        multiplier, rest[4], rest[5]));
  table.type = type == 1 ? PhotometricType::c : type == 2 ? PhotometricType::b : PhotometricType::a;
  table.angle = numbers.next(vertical, "the vertical angles");
  require_rising(numbers, table.angle, "vertical");
  if (table.type != PhotometricType::c && (table.angle.front() != -90 || table.angle.back() != 90))
    numbers.refuse(fmt::format("vertical angles of type A or B from {} to {}; give -90 to 90 degrees",
                               table.angle.front(), table.angle.back()));
  table.plane = numbers.next(horizontal, "the horizontal angles");
  require_rising(numbers, table.plane, "horizontal");
  Planes planes;
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
    complete_turn(numbers, table.plane, planes);
  }
  for (const std::vector<double>& plane : planes)
    table.intensity.insert(table.intensity.end(), plane.begin(), plane.end());
  return table;
}

}  // namespace etendue
