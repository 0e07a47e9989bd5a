// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/base/vec3.h"
#include "solver/problem/directional_scattering.h"

namespace etendue {

/// Leaf normals and their shares, which sum to 1, over the upper hemisphere.
struct LeafNormals {
  std::vector<Vec3> normals;
  std::vector<double> shares;
};
LeafNormals leaf_normals(LeafAngles angles);

/// Ross's G (Ross 1981): the mean projection of a unit of leaf area along a direction; 1/2 in the mean over
/// directions.
double leaf_projection(LeafAngles angles, const Vec3& direction);

}  // namespace etendue
