// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/tetrahedra/raw_mesh.h"

namespace etendue {

/// Every cell in eight of an eighth of its volume, every named triangle in four: red refinement (Bey 1995).
/// Four cells are the corners, similar to the whole; the octahedron that is left is cut along the shortest of
/// its diagonals (Zhang 1995), which keeps the shapes of repeated refinement bounded. The meshes are nested,
/// and walls stay where they are: facets of a curved wall become no rounder. `mesh` must be sound: one that
/// TetrahedralMesh takes. What the file calls points and cells is not handed on.
RawMesh red_refinement(const RawMesh& mesh);

}  // namespace etendue
