// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>

#include "mesh/tetrahedra/connectivity.h"
#include "mesh/tetrahedra/raw_mesh.h"

namespace etendue {

/// Throws InputError where the mesh does not conform: where a boundary vertex lies on a boundary face or
/// edge that it is no corner of (a hanging node), or where boundary faces cover each other (two sides cut
/// differently). What looks like boundary there are cells that touch without sharing faces.
void check_boundary_conforms(std::span<const Vec3> points, const MeshFaces& faces,
                             const MeshNumbering& numbering, const RawMesh& raw);

}  // namespace etendue
