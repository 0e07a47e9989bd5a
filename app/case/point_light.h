// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "app/case/case.h"
#include "solver/problem/lights/light.h"

namespace etendue {

/// The point light of a lamp, or of the table of a sky, with its axes and angles in radians.
PointLight point_light(const LightCase& light);

}  // namespace etendue
