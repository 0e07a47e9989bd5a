// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include "mesh/polyhedra/polyhedral_mesh.h"
#include "mesh/tetrahedra/raw_mesh.h"

namespace etendue {

/// Cuts cells into tetrahedra that conform. A face becomes triangles that meet in one of its points: the one
/// of the lowest number from which all triangles have an area, the same from both sides. A cell becomes
/// tetrahedra from its centroid to the triangles of its faces; tetrahedra and triangles stay as they are.
/// Points of the mesh keep their numbers. Throws InputError with number and place of a cell whose faces do
/// not enclose it, or which has a tetrahedron of no positive volume.
RawMesh cut_polyhedra(std::shared_ptr<const PolyhedralMesh> mesh);

}  // namespace etendue
