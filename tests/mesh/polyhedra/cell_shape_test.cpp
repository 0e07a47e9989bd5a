// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/polyhedra/cell_shape.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "base/position.h"
#include "tests/mesh/polyhedra/sample_polyhedra.h"

namespace etendue::cell_shape_test {
namespace {

using namespace sample_polyhedra;

CellShape shape_in(const PolyhedralMesh& mesh) { return shape_of_cell(mesh, FacesOfCells(mesh).of(0)); }

/// Component along the normal of the base of the edge from the base to the first point above it.
double height_of(const PolyhedralMesh& mesh, const CellShape& shape, std::size_t base) {
  const auto at = [&](std::size_t i) { return mesh.points[position(shape.points[i])]; };
  return (at(1) - at(0)).cross(at(2) - at(0)).dot(at(base) - at(0));
}

TEST(CellShape, IsFoundOfPyramids) {
  for (const auto& [mesh, base] : {std::pair(tetrahedron(), 3U), std::pair(pyramid(), 4U)}) {
    const CellShape shape = shape_in(mesh);
    EXPECT_EQ(shape.kind, CellKind::pyramid);
    ASSERT_EQ(shape.points.size(), base + 1);
    EXPECT_GT(height_of(mesh, shape, base), 0);
  }
}

TEST(CellShape, IsFoundOfPrismsWithThePointsAboveEachOther) {
  for (const auto& [mesh, base] : {std::pair(prism(), 3U), std::pair(hexahedra({1, 1, 1}), 4U)}) {
    const CellShape shape = shape_in(mesh);
    EXPECT_EQ(shape.kind, CellKind::prism);
    ASSERT_EQ(shape.points.size(), 2 * base);
    EXPECT_GT(height_of(mesh, shape, base), 0);
    for (std::size_t i = 0; i < base; ++i)
      EXPECT_NEAR(
          (mesh.points[position(shape.points[i])] - mesh.points[position(shape.points[base + i])]).norm(), 1,
          1e-15);
  }
}

/// A pyramid with a point in the middle of an edge of its sides: as many faces of each size as a wedge.
PolyhedralMesh pyramid_with_hanging_point() {
  PolyhedralMesh mesh;
  mesh.points = {Vec3(0, 0, 0), Vec3(1, 0, 0),   Vec3(1, 1, 0),
                 Vec3(0, 1, 0), Vec3(.5, .5, 1), Vec3(.25, .25, .5)};
  const std::vector<std::vector<int>> faces = {
      {4, 5, 0, 1}, {4, 1, 2}, {4, 2, 3}, {4, 3, 0, 5}, {0, 3, 2, 1}};
  for (const std::vector<int>& face : faces) {
    mesh.face_points.insert(mesh.face_points.end(), face.begin(), face.end());
    mesh.face_ends.push_back(static_cast<int>(mesh.face_points.size()));
    mesh.owners.push_back(0);
    mesh.neighbors.push_back(-1);
    mesh.face_walls.push_back(-1);
  }
  mesh.cell_regions = {0};
  mesh.region_names = {"domain"};
  return mesh;
}

TEST(CellShape, IsNoPrismWhoseSidesAreNotItsFaces) {
  EXPECT_EQ(shape_in(pyramid_with_hanging_point()).kind, CellKind::polyhedron);
}

TEST(CellShape, IsAPolyhedronOtherwise) {
  for (const PolyhedralMesh& mesh : {hexagonal_prism(), truncated_cube(), cube_of_nine_faces()})
    EXPECT_EQ(shape_in(mesh).kind, CellKind::polyhedron);
}

}  // namespace
}  // namespace etendue::cell_shape_test
