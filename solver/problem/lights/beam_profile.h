// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/vec3.h"

namespace etendue {

/// Cross-section of a collimated beam: the irradiance of each of its rays over that on the axis. Disc: 1
/// within the radius, which is a regular polygon of `beam_sides` sides and the area of the circle. Gaussian:
/// exp(-2 r^2/w^2), the radius w being that at 1/e^2 (ISO 11146-1:2021, 3.5).
struct BeamProfile {
  enum class Shape { disc, gaussian };
  Shape shape = Shape::disc;
  Vec3 center = Vec3::Zero();  ///< a point on the axis
  /// Coordinates of a ray through x, in units of the radius: across.(x - center) and upright.(x - center).
  /// Both are perpendicular to the beam, so that they are the same along a ray [1/length].
  Vec3 across = Vec3::UnitX(), upright = Vec3::UnitY();
};

constexpr int beam_sides = 64;
/// Radii beyond which a Gaussian beam has 2e-11 of its irradiance and of its power; it ends there.
constexpr double gaussian_end = 3.5;
/// Distance from the axis of the sides of a disc, in units of the radius.
double disc_apothem();
/// Normal of a side of the disc in the coordinates of the profile, as a vector of space [1/length].
Vec3 disc_side(const BeamProfile& profile, int side);

/// Irradiance of the ray through a point over that on the axis.
double relative_irradiance(const BeamProfile& profile, const Vec3& point);
/// Distance from the axis of the ray through a point, in units of the radius.
double distance_from_axis(const BeamProfile& profile, const Vec3& point);
/// Power of the whole beam over its irradiance on the axis, for a radius [length^2].
double profile_area(BeamProfile::Shape shape, double radius);

}  // namespace etendue
