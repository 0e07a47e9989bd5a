// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/radiosity/flat_patch.h"

namespace etendue {

/// A part of a boundary face.
struct FacePart {
  std::size_t patch = 0;
  double share = 1;  ///< of the face's area
};

/// The walls of a mesh as flat patches that look into the domain.
struct WallPatches {
  std::vector<FlatPatch> patches;
  std::vector<int> walls;                       ///< [patch]
  std::vector<std::vector<FacePart>> of_faces;  ///< [boundary face]
};

/// With size 0 each boundary face is a patch. Else faces whose longest side exceeds it are cut in four until
/// none does, and smaller ones are joined where they lie on one wall, in one square of a grid with that side
/// [length], and are flat_neighbours(): no patch passes under a sheet.
WallPatches wall_patches(const TetrahedralMesh& mesh, double size);

/// All triangles of patches, one after the other.
std::vector<TriangleCorners> triangles_of(const std::vector<FlatPatch>& patches);

}  // namespace etendue
