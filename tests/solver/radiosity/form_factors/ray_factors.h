// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solver/radiosity/form_factors/flat_patch.h"
#include "solver/radiosity/form_factors/ray_scene.h"

namespace etendue {

/// Monte Carlo estimate of a form factor.
struct DrawnFactor {
  double value = 0;
  double error = 0;  ///< standard error of a share of independent rays
};

/// Rays that leave a surface as its diffuse light does.
struct LeavingRays {
  std::uint64_t count = 1;
  std::uint64_t seed = 1;
};

/// Form factors of a surface of triangles, curved or not, to the groups that the scene's triangles belong to:
/// the share of rays that meet each first. `group_of` is [triangle of the scene], and is below `groups`; the
/// last entry of the result is what meets nothing. The same for any number of threads.
std::vector<DrawnFactor> factors_by_rays(const std::vector<TriangleCorners>& from, const RayScene& scene,
                                         const std::vector<std::size_t>& group_of, std::size_t groups,
                                         const LeavingRays& rays, int threads = 1);

}  // namespace etendue
