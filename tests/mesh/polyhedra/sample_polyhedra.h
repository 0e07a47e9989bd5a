// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <vector>

#include "mesh/polyhedra/polyhedral_mesh.h"

namespace etendue::sample_polyhedra {

/// A box of hexahedra with walls xmin … zmax, in the order of OpenFOAM: faces within, then those of each
/// wall. Points count along x, then y, then z.
PolyhedralMesh hexahedra(const std::array<int, 3>& cells, const Vec3& size = Vec3(1, 1, 1));

/// A mesh of one cell with these faces and one wall, "boundary".
PolyhedralMesh single_cell(std::vector<Vec3> points, const std::vector<std::vector<int>>& faces);

PolyhedralMesh prism();               ///< a base of three points and the same above it; volume 1/2
PolyhedralMesh pyramid();             ///< on a unit square, its apex above the center; volume 1/3
PolyhedralMesh tetrahedron();         ///< volume 1/6
PolyhedralMesh hexagonal_prism();     ///< volume 3 sqrt(3)/2
PolyhedralMesh truncated_cube();      ///< a unit cube without a corner of three edges of 1/2; volume 47/48
PolyhedralMesh cube_of_nine_faces();  ///< a unit cube whose floor is four squares, as beside finer cells

/// Writes points, faces, owner, neighbour, boundary and cellZones in constant/polyMesh as text.
void write_foam_mesh(const std::filesystem::path& folder, const PolyhedralMesh& mesh);

}  // namespace etendue::sample_polyhedra
