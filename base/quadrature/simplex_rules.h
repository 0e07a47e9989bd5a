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
std::array<SubTetrahedron, 8> equal_parts(const SubTetrahedron& whole);

/// A triangle inside of a face: the face's barycentric coordinates of its three corners.
using SubTriangle = std::array<std::array<double, 3>, 3>;

constexpr SubTriangle whole_face = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
/// Four parts of equal area.
std::array<SubTriangle, 4> equal_parts(const SubTriangle& whole);

/// Coordinates in the whole of a point of a part.
template <std::size_t corners>
std::array<double, corners> in_whole(const std::array<double, corners>& barycentric,
                                     const std::array<std::array<double, corners>, corners>& part) {
  std::array<double, corners> whole{};
  for (std::size_t i = 0; i < corners; ++i)
    for (std::size_t k = 0; k < corners; ++k) whole[k] += barycentric[i] * part[i][k];
  return whole;
}

template <std::size_t corners>
struct SimplexPoint {
  std::array<double, corners> barycentric;
  double weight;  ///< part of the volume or area
};
using CellPointWeight = SimplexPoint<4>;
using FacePointWeight = SimplexPoint<3>;

/// Four points, degree 2 (Hammer and Stroud 1956).
const std::array<CellPointWeight, 4>& four_point_rule();
/// Three points, degree 2, and seven points, degree 5 (Radon 1948).
const std::array<FacePointWeight, 3>& three_point_rule();
const std::array<FacePointWeight, 7>& seven_point_rule();

}  // namespace etendue
