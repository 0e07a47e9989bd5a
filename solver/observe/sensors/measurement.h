// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vec3.h"

namespace etendue {

/// What sensors report, in the words and units of radiometry.
enum class RadiometricQuantity {
  irradiance,  ///< through the sensor's plane [power/length^2]; of a cone the light from within it
  /// Of all that leaves a wall, be it emitted, reflected or let through (CIE S 017:2020, 17-21-080)
  /// [power/length^2]
  exitance,
  radiosity,        ///< another name of it
  fluence,          ///< from all sides [power/length^2]
  radiance,         ///< from one direction [power/(length^2 sr)]
  radiance_mean,    ///< over the cone [power/(length^2 sr)]
  irradiance_mean,  ///< over a grid
  irradiance_least,
  irradiance_most,
  flux_forward,    ///< power through a polygon in the direction of its normal, or out by a wall [power]
  flux_backward,   ///< against it [power]
  flux_net,        ///< forward less backward [power]
  intensity_most,  ///< of all directions [power/sr]
  path,            ///< radiance integrated over a region and directions [power length]
  flowing_in,      ///< terms of the account of a region [power]
  flowing_out,
  emitted,
  absorbed,
  scattered_in,
  scattered_out,
  solid_angle,      ///< of the directions that count [sr]
  account_residual  ///< what the account misses, relative
};

/// A quantity in every band, in two parts: light of lights that has not scattered or been reflected diffusely
/// yet, and all other light.
struct Measurement {
  RadiometricQuantity quantity;
  std::vector<double> uncollided;  ///< [band]
  std::vector<double> collided;    ///< [band]
  /// [band] estimate of what the sum over rays is off by; 0 where no sum is taken. The error of the solution
  /// itself is not in it.
  std::vector<double> error;
};

/// [row][column][band]: the irradiance at the points of a grid, its second side down; or the radiant
/// intensity of what leaves by a wall, a row for each polar angle and a column for each azimuth.
struct GridReading {
  std::vector<double> uncollided;
  std::vector<double> collided;
};

/// What an observer sees of the half space ahead, in an equidistant fisheye picture of equal sides.
struct ObservedView {
  int across = 0;                   ///< pixels of a side
  std::vector<Vec3> directions;     ///< [row from the top][column] unit, away from the observer
  std::vector<double> solid_angle;  ///< [row][column] [sr]; 0 outside of the circle
  std::vector<double> uncollided;   ///< [row][column][band] radiance
  std::vector<double> collided;     ///< [row][column][band]
  /// Light of points, spots and suns, which no pixel shows, directly and by mirrors.
  struct Beam {
    Vec3 towards;                    ///< unit, to where it comes from
    std::vector<double> irradiance;  ///< [band] on a plane across it
    double distance;                 ///< of a point [length]; 0: a sun
  };
  std::vector<Beam> beams;
};

struct SensorReading {
  std::vector<Measurement> measurements;
  GridReading grid;        ///< empty for other kinds
  ObservedView view = {};  ///< of glare
};

}  // namespace etendue
