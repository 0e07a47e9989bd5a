// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/errors.h"
#include "base/vec3.h"
#include "solver/problem/lights/beam_profile.h"

namespace etendue {

/// How an emission of the problem is treated: its uncollided light by exact rays, or by the directions.
enum class Uncollided { automatic, yes, no };

/// Light from a point.
struct PointLight {
  Vec3 position = Vec3::Zero();
  std::vector<double> power;  ///< [band] into all directions [power]
  Vec3 axis = Vec3::UnitZ();  ///< unit
  /// Intensity [plane][angle] over rising angles from the axis [rad], linear between them and zero beyond;
  /// only its shape counts. Empty: the same in all directions.
  std::vector<double> angle;
  std::vector<double> intensity;
  /// Rising azimuths about the axis [rad] of the half planes in which the intensity is given, linear between
  /// them and zero beyond, of one turn at most. Empty: one for all, the same all about the axis.
  std::vector<double> plane = {};
  Vec3 zero_plane = Vec3::UnitX();     ///< unit, across the axis: azimuth 0
  Vec3 quarter_plane = Vec3::UnitY();  ///< unit, across both: azimuth pi/2
};

/// Collimated light that enters through walls which do not mirror.
struct BeamLight {
  Vec3 direction = -Vec3::UnitZ();  ///< unit, in which the light travels
  std::vector<double> irradiance;   ///< [band] on a plane across the beam, on its axis [power/length^2]
  std::vector<int> walls;
  double solid_angle = 0;  ///< [sr] of the part of a sky that it represents; 0: it comes from one direction
  std::optional<BeamProfile> profile = {};  ///< without one the beam is as wide as its walls
};

/// A flat light inside of the domain that shines from one side and stands in nobody's way.
struct SurfaceLight {
  std::vector<Vec3> triangles;   ///< three corners each, counterclockwise seen from the side that shines
  std::vector<double> radiance;  ///< [band] [power/(length^2 sr)]
};

/// What shines beside media and walls; its uncollided part is exact unless it says no.
struct Light {
  std::string name;
  std::variant<PointLight, BeamLight, SurfaceLight> kind;
  Origin origin;
  Uncollided uncollided = Uncollided::automatic;
};

}  // namespace etendue
