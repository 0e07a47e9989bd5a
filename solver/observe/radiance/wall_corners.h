// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/tetrahedra/tetrahedral_mesh.h"

namespace etendue {

/// The corners of boundary faces around each vertex that lie in one plane, plane by plane: what a plane
/// receives is continuous, and jumps at edges and where a sheet stands on it.
struct WallCorner {
  FaceIndex face;
  std::size_t node;
};
std::vector<std::vector<WallCorner>> corners_by_plane(const TetrahedralMesh& mesh);

/// Irradiance is continuous across the border of two walls in one plane; exitance is not.
enum class WallBorders { continuous, cut };

/// Values [boundary face][`face_nodes`: 3 or 1][band] made continuous, [boundary face][3][band]: the mean,
/// weighted by area, over the faces of one plane around a vertex (Clément 1975).
std::vector<double> joined_on_planes(const TetrahedralMesh& mesh, std::span<const double> values,
                                     std::size_t face_nodes, std::size_t bands,
                                     WallBorders borders = WallBorders::continuous);

/// Barycentric coordinates of a point of a boundary face, in the order of its vertices.
std::array<double, 3> barycentric(const TetrahedralMesh& mesh, FaceIndex face, const Vec3& point);

}  // namespace etendue
