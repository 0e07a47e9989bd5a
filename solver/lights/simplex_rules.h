// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

namespace etendue {

/// A tetrahedron inside of a cell: the cell's barycentric coordinates of its four corners.
using SubTetrahedron = std::array<std::array<double, 4>, 4>;

/// The whole cell.
SubTetrahedron whole_cell();
/// Eight parts of equal volume: four at the corners, four around a diagonal of the octahedron between them.
std::array<SubTetrahedron, 8> eight_parts(const SubTetrahedron& whole);

struct CellPointWeight {
  std::array<double, 4> barycentric;
  double weight;  ///< part of the volume
};
struct FacePointWeight {
  std::array<double, 3> barycentric;
  double weight;  ///< part of the area
};

/// Four points, degree 2 (Hammer and Stroud 1956).
const std::array<CellPointWeight, 4>& four_point_rule();
/// Three points, degree 2, and seven points, degree 5 (Radon 1948).
const std::array<FacePointWeight, 3>& three_point_rule();
const std::array<FacePointWeight, 7>& seven_point_rule();

}  // namespace etendue
