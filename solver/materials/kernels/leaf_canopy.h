// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vec3.h"
#include "solver/materials/kernels/directional_scattering.h"

namespace etendue {

/// Leaf normals and their shares, which sum to 1, over the upper hemisphere.
struct LeafNormals {
  std::vector<Vec3> normals;
  std::vector<double> shares;
};
LeafNormals leaf_normals(LeafAngles angles);

/// Density of the inclination of the normals from the vertical [1/rad], with integral 1 over [0, pi/2] (de
/// Wit 1965, in the trigonometric form of Bunnik 1978); not of leaves that are all level or upright.
double inclination_density(LeafAngles angles, double inclination);

/// The mean over directions of Ross's G.
inline constexpr double mean_leaf_projection = 0.5;

/// Ross's G (Ross 1981): the mean projection of a unit of leaf area along a direction.
double leaf_projection(LeafAngles angles, const Vec3& direction);

/// Ross's kernel k(before -> after) for a leaf area density of 1 [1/sr]: the mean over leaves of
/// |before.n||after.n|/pi times the transmittance where light goes through, else the reflectance. `normals`
/// are those of its leaves.
double leaf_value(const LeafCanopy& leaves, const LeafNormals& normals, const Vec3& before,
                  const Vec3& after);

}  // namespace etendue
