// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/lights/read_sun.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <regex>

#include "base/degree.h"
#include "solver/problem/sky/sun_position.h"

namespace etendue {
namespace {

/// Sets year, month and day; whether the text is a date of the years that the formulas hold for.
bool read_date(Section& section, PlaceAndTime& place) {
  if (section.find("date") == nullptr) return false;
  const std::string text = section.text("date");
  std::smatch parts;
  const bool looks = std::regex_match(text, parts, std::regex(R"((\d{4})-(\d{2})-(\d{2}))"));
  if (looks) {
    place.year = std::stoi(parts[1]);
    place.month = std::stoi(parts[2]);
    place.day = std::stoi(parts[3]);
    const std::chrono::year_month_day date = std::chrono::year(place.year) / place.month / place.day;
    if (date.ok() && place.year >= 1950 && place.year <= 2050) return true;
  }
  section.fault("date", "is no date from 1950 to 2050; give \"year-month-day\", e.g. \"2026-06-21\"");
  return false;
}

bool read_time(Section& section, PlaceAndTime& place) {
  if (section.find("time") == nullptr) return false;
  const std::string text = section.text("time");
  std::smatch parts;
  if (std::regex_match(text, parts, std::regex(R"((\d{1,2}):(\d{2})(:(\d{2}))?)"))) {
    const int hours = std::stoi(parts[1]), minutes = std::stoi(parts[2]);
    const int seconds = parts[4].matched ? std::stoi(parts[4]) : 0;
    place.hour = hours + minutes / 60. + seconds / 3600.;
    if (hours < 24 && minutes < 60 && seconds < 60) return true;
  }
  section.fault("time", "is no time of the day; give \"hours:minutes\" from \"00:00\" to \"23:59\"");
  return false;
}

constexpr std::array<const char*, 5> place_keys = {"date", "time", "latitude", "longitude", "time_zone"};

/// By date, time and place.
bool read_moment(Section& section, SunPlace& sun) {
  // All are asked for, so that none of them is called unused where another is missing.
  for (const char* key : place_keys) section.find(key);
  for (const char* key : place_keys)
    if (!section.has(key)) {
      section.fault(fmt::format(
          "needs altitude and azimuth, or date, time, latitude, longitude and time_zone; add {}", key));
      return false;
    }
  PlaceAndTime place;
  const bool date = read_date(section, place), time = read_time(section, place);
  const auto latitude = section.number_if("latitude"), longitude = section.number_if("longitude"),
             zone = section.number_if("time_zone");
  if (!date || !time || !latitude || !longitude || !zone) return false;
  place.latitude = *latitude;
  place.longitude = *longitude;
  place.time_zone = *zone;
  const SunPosition position = sun_position(place);
  sun.altitude = position.altitude;
  sun.azimuth = position.azimuth;
  sun.eccentricity = sun_eccentricity(place.year, place.month, place.day);
  return true;
}

bool read_angles(Section& section, SunPlace& sun) {
  for (const char* key : place_keys) section.unused(key, "altitude and azimuth are given");
  const auto altitude = section.number_if("altitude"), azimuth = section.number_if("azimuth");
  if (!section.has("altitude") || !section.has("azimuth"))
    section.fault("needs altitude and azimuth; add the other");
  if (!altitude || !azimuth) return false;
  sun.altitude = *altitude;
  sun.azimuth = *azimuth;
  return true;
}

}  // namespace

std::optional<SunPlace> read_sun_position(Section& light) {
  if (!light.has("sun_position")) return {};
  Section section = light.section("sun_position");
  SunPlace sun;
  const Vec3 north = to_vec3(section.value("north"));
  const bool angles = section.has("altitude") || section.has("azimuth");
  if (!(angles ? read_angles(section, sun) : read_moment(section, sun))) return {};
  if (north.z() != 0 || north.norm() == 0) {
    section.fault("north", "is no level direction; use one with z = 0");
    return {};
  }
  sun.north = north.normalized();
  if (!(sun.altitude > 0)) {
    light.fault("sun_position",
                fmt::format("has the sun below the horizon (altitude {:.2f} degrees); use another time",
                            sun.altitude));
    return {};
  }
  const double altitude = sun.altitude * one_degree, azimuth = sun.azimuth * one_degree;
  const Vec3 east = sun.north.cross(Vec3::UnitZ());
  sun.to_sun = std::cos(altitude) * (std::cos(azimuth) * sun.north + std::sin(azimuth) * east) +
               std::sin(altitude) * Vec3::UnitZ();
  return sun;
}

}  // namespace etendue
