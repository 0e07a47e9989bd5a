// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "solver/radiosity/form_factors/flat_patch.h"

namespace etendue {

/// A triangle of a patch: a boundary face, or a quarter of a quarter … of one.
struct PatchPiece {
  std::int32_t face = 0;
  std::uint64_t quarters = 1;  ///< 1, then two bits for each quartering: see quarter_of()
  TriangleCorners corners;     ///< counterclockwise seen from the domain
};

/// A part of a boundary face.
struct FacePart {
  std::size_t patch = 0;
  double share = 1;            ///< of the face's area
  std::uint64_t quarters = 1;  ///< of its piece
};

/// The walls of a mesh as flat patches that look into the domain.
struct WallPatches {
  std::vector<FlatPatch> patches;
  std::vector<int> walls;                       ///< [patch]
  std::vector<double> sizes;                    ///< [patch] that it was made to [length]
  std::vector<std::vector<PatchPiece>> pieces;  ///< [patch] its triangles
  std::vector<std::vector<FacePart>> of_faces;  ///< [boundary face]
};

/// With size 0 each boundary face is a patch, and its longest side is its size. Else faces whose longest side
/// exceeds it are cut in four until none does, and smaller ones are joined where they lie on one wall, in one
/// square of a grid with that side [length], and are flat_neighbours(): no patch passes under a sheet.
WallPatches wall_patches(const TetrahedralMesh& mesh, double size);

/// The same with some of the patches [patch] made anew to half of their size.
WallPatches refined_patches(const TetrahedralMesh& mesh, const WallPatches& patches,
                            const std::vector<bool>& cut);

/// The face as a triangle, counterclockwise seen from the domain.
TriangleCorners inward_triangle(const TetrahedralMesh& mesh, FaceIndex face);

/// A quarter of a triangle: those at its corners 0, 1, 2 replace these, 3 is in the middle.
TriangleCorners quarter_of(const TriangleCorners& triangle, std::size_t quarter);

/// [boundary face][3][band] Means of values [patch][band] over each face, weighted by the linear function
/// that is 1 at one of its vertices and 0 at the others. Their mean by area over the faces around a vertex is
/// the projection on continuous functions with a lumped mass matrix: the mean is kept, nothing becomes
/// negative.
std::vector<double> means_at_vertices(const TetrahedralMesh& mesh, const WallPatches& patches,
                                      const std::vector<double>& values, std::size_t bands);

/// All triangles of patches, one after the other.
std::vector<TriangleCorners> triangles_of(const std::vector<FlatPatch>& patches);

}  // namespace etendue
