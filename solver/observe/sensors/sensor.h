// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// What an instrument measures.
enum class SensorKind {
  irradiance,  ///< at a point, on the side that the normal points to
  exitance,    ///< at a point of a wall, all that leaves it into the domain
  radiosity,   ///< the same by the name that it has in radiative transfer between surfaces
  fluence,     ///< at a point, from all sides
  radiance,    ///< at a point, from the direction in which it looks
  cone,        ///< at a point, from all directions within an angle of the one in which it looks
  grid,        ///< irradiance at the middles of equal parts of a parallelogram
  flux,        ///< power through a flat polygon or a whole wall, to both sides
  intensity,   ///< of the light that leaves the domain by a wall, over directions
  region,      ///< the account of a region, of all light or of that from within a cone
  glare        ///< discomfort glare of an observer
};

/// What is a source of glare in the view of an observer.
enum class GlareSources {
  threshold,  ///< what is brighter than a threshold (evalglare; Wienold and Christoffersen 2006)
  lights      ///< what shines as a light, seen directly or in mirrors
};

/// An instrument, anywhere in the domain or on a wall.
struct Sensor {
  SensorKind kind = SensorKind::irradiance;
  Vec3 position = Vec3::Zero();    ///< of a grid its first corner
  Vec3 direction = Vec3::UnitZ();  ///< unit: the normal, or where it looks; never that of the light
  /// [rad] of a cone, and of a flux or region that counts what comes from within a cone alone; 0: from
  /// everywhere
  double half_angle = 0;
  std::array<Vec3, 2> sides = {};  ///< of a grid, from its first corner [length]
  /// Of a grid, parts of its sides; of a polygon the first, see SensorReader; of intensities, azimuths and
  /// polar angles; of glare, pixels across the view.
  std::array<int, 2> count = {1, 1};
  std::vector<Vec3> polygon = {};  ///< corners, in order, of a flux
  int wall = -1;                   ///< of intensities; of a flux in place of a polygon
  Vec3 up = Vec3::UnitZ();         ///< of glare, of any length: what points up for the observer
  GlareSources glare_sources = GlareSources::threshold;
  /// Of glare [cd/m^2]; up to 100 a factor of the mean luminance of the view.
  double glare_threshold = 2000;
  int rays = 2000;  ///< at most, from one point, for other light than that of lights
};

/// The middle of a part of a grid.
Vec3 grid_point(const Sensor& sensor, int i, int j);

/// Unit normal of a polygon, from which its corners stand counterclockwise; the length is lost where they
/// are in a line.
Vec3 polygon_normal(const std::vector<Vec3>& polygon);

}  // namespace etendue
