// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// A place on the earth and a moment there.
struct PlaceAndTime {
  double latitude = 0;   ///< [degree], north positive
  double longitude = 0;  ///< [degree], east positive
  double time_zone = 0;  ///< [h] of the clock ahead of universal time
  int year = 2000, month = 1, day = 1;
  double hour = 12;  ///< of the clock, with fractions
};

struct SunPosition {
  double altitude;    ///< [degree] above the horizon, as refraction lets it appear at sea level
  double azimuth;     ///< [degree] clockwise from north
  double refraction;  ///< [degree], part of the altitude
};

/// The sun's position from 1950 to 2050 to about 0.01 degree: the Astronomical Almanac's low-precision
/// formulas (Michalsky, Solar Energy 40 (1988) 227).
SunPosition sun_position(const PlaceAndTime& place);

/// Square of the mean over the present distance of the sun (Spencer 1971).
double sun_eccentricity(int year, int month, int day);

}  // namespace etendue
