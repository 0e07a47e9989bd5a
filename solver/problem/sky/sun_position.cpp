// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/sky/sun_position.h"

#include <chrono>
#include <cmath>
#include <numbers>

#include "base/degree.h"

namespace etendue {
namespace {

using std::numbers::pi;

/// Days from noon of 1 January 2000, universal time.
double days_since_2000(const PlaceAndTime& place) {
  using namespace std::chrono;
  const sys_days date = year(place.year) / place.month / place.day;
  const auto days = (date - sys_days(year(2000) / 1 / 1)).count();
  return static_cast<double>(days) - 0.5 + (place.hour - place.time_zone) / 24;
}

/// [degree] that the air at sea level lifts the sun by (Michalsky 1988).
double refraction_at(double altitude) {
  if (altitude >= 19.225) return 0.00452 * 3.51561 / std::tan(altitude * one_degree);
  if (altitude > -0.766)
    return 3.51561 * (0.1594 + 0.0196 * altitude + 0.00002 * altitude * altitude) /
           (1 + 0.505 * altitude + 0.0845 * altitude * altitude);
  return 0;
}

}  // namespace

SunPosition sun_position(const PlaceAndTime& place) {
  const double n = days_since_2000(place);
  const double mean_longitude = 280.460 + 0.9856474 * n,
               mean_anomaly = (357.528 + 0.9856003 * n) * one_degree;
  const double longitude =
      (mean_longitude + 1.915 * std::sin(mean_anomaly) + 0.020 * std::sin(2 * mean_anomaly)) * one_degree;
  const double obliquity = (23.439 - 0.0000004 * n) * one_degree;
  const double right_ascension = std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude));
  const double declination = std::asin(std::sin(obliquity) * std::sin(longitude));
  // Greenwich mean sidereal time [h].
  const double universal = place.hour - place.time_zone;
  const double sidereal = 6.697375 + 0.0657098242 * n + universal;
  const double hour_angle = (sidereal * 15 + place.longitude) * one_degree - right_ascension;
  const double latitude = place.latitude * one_degree;
  const double east = -std::cos(declination) * std::sin(hour_angle);
  const double north = std::sin(declination) * std::cos(latitude) -
                       std::cos(declination) * std::cos(hour_angle) * std::sin(latitude);
  const double up = std::sin(declination) * std::sin(latitude) +
                    std::cos(declination) * std::cos(hour_angle) * std::cos(latitude);
  const double altitude = std::atan2(up, std::hypot(east, north)) / one_degree;
  const double azimuth = std::atan2(east, north) / one_degree;
  const double lifted = refraction_at(altitude);
  return {altitude + lifted, azimuth < 0 ? azimuth + 360 : azimuth, lifted};
}

double sun_eccentricity(int year, int month, int day) {
  using namespace std::chrono;
  const auto number =
      (sys_days(std::chrono::year(year) / month / day) - sys_days(std::chrono::year(year) / 1 / 1)).count();
  const double angle = 2 * pi * static_cast<double>(number) / 365;
  return 1.00011 + 0.034221 * std::cos(angle) + 0.00128 * std::sin(angle) + 0.000719 * std::cos(2 * angle) +
         0.000077 * std::sin(2 * angle);
}

}  // namespace etendue
