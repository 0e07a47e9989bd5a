// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/problem/problem.h"

namespace etendue {

/// A slab 0 < x < 1 between black walls, mirrors at its other sides: sigma_t = 1/epsilon, sigma_a = epsilon,
/// q = epsilon/(4 pi). As epsilon -> 0 the fluence tends to the solution of -phi''/3 + phi = 1, phi = 0 at
/// both ends (Larsen and Keller 1974). `mesh` is of the unit cube.
Problem diffusive_slab(const TetrahedralMesh& mesh, double epsilon);
/// That solution.
double diffusive_slab_fluence(const Vec3& point);
/// 1e-6, or what rounding leaves: that of a sweep, 1e-16, is an error of 1e-16/epsilon^2 in the fluence.
double diffusive_slab_tolerance(double epsilon);

}  // namespace etendue
