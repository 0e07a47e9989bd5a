// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "solver/problem/lights/light.h"
#include "solver/problem/lights/tangent_cone.h"

namespace etendue {

/// Integral of a lamp's shape (lamp_shape.h) over the directions that lead into the domain [sr times the
/// shape's unit].
double integral_of_lamp_shape(const PointLight& light, const TangentCone& cone);

}  // namespace etendue
