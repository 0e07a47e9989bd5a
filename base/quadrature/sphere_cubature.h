// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "base/vec3.h"

namespace etendue {

/// Two functions of a direction, taken at one time.
using PairOnSphere = std::function<std::array<double, 2>(const Vec3&)>;

struct SphereIntegrals {
  std::array<double, 2> values{};
  std::array<double, 2> errors{};  ///< estimates, mostly several times too large
};

/// Integrals over the sphere by patches of polar angle and azimuth that are halved where they are least
/// certain, until the errors are below `relative` of the integrals or 1,500 patches have been made (van
/// Dooren and de Ridder 1976). The axes' planes are borders of patches, so kinks and steps there cost
/// nothing; peaks at `suspects` are found though they are 0.01 wide.
SphereIntegrals integrate_over_sphere(const PairOnSphere& functions, const std::vector<Vec3>& suspects,
                                      double relative);

}  // namespace etendue
