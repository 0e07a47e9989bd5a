// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "base/vec3.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/problem/problem.h"

namespace etendue {

/// A flat part of the boundary that reflects ordinates into ordinates: a mirror, or a surface with a medium
/// of another refractive index behind it.
struct SmoothPlane {
  Vec3 normal;              ///< unit; its sign does not matter
  double refractive_index;  ///< of the domain over that behind; 1: a mirror
};

/// The different smooth planes of a boundary. Parallel planes of one index are the same.
std::vector<SmoothPlane> smooth_planes(const TetrahedralMesh& mesh, std::span<const Wall> walls);

}  // namespace etendue
