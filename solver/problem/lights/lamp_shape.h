// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/problem/lights/light.h"

namespace etendue {

/// The shape of a lamp's intensity, of any unit, at an angle from its axis and an azimuth about it [rad],
/// linear in both between those given and zero beyond them; 1 without a table.
double lamp_shape(const PointLight& light, double angle, double azimuth);
/// The same in a direction; the sine of a small angle from the axis is the sounder measure of it.
double lamp_shape(const PointLight& light, const Vec3& direction);

/// Its integral over the sphere.
double integral_of_lamp_shape(const PointLight& light);

/// [angle] Its integral over the azimuth.
std::vector<double> lamp_shape_about_axis(const PointLight& light);

/// Angles from the axis at which the intensity jumps or bends sharply, as at the edge of a cone, rising:
/// those of the sharpest where they are many [rad].
std::vector<double> edges_of_lamp_shape(const PointLight& light);

}  // namespace etendue
