// SPDX-License-Identifier: AGPL-3.0-or-later
// What is said of meshes that are wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "base/errors.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::mesh_faults_test {
namespace {

std::string message_of(const RawMesh& raw) {
  try {
    TetrahedralMesh mesh(raw);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// A tetrahedron of the given points and a second one on its face opposite point 0.
RawMesh two_tetrahedra(const Vec3& apex) {
  RawMesh raw = single_tetrahedron_raw();
  raw.points.push_back(apex);
  raw.cells.push_back({1, 2, 3, 4});
  raw.cell_regions.push_back(0);
  return raw;
}

TEST(MeshFaults, NameTheInvertedCellWithItsLine) {
  RawMesh raw = kuhn_cube_raw();
  raw.file = "cube.ele";
  raw.cell_lines = {2, 3, 4, 5, 6, 7};
  raw.cell_numbers = {1, 2, 3, 4, 5, 6};
  raw.point_numbers = {1, 2, 3, 4, 5, 6, 7, 8};
  std::swap(raw.cells[3][0], raw.cells[3][1]);
  const auto& v = raw.cells[3];
  std::string vertices;
  for (const int point : v) vertices += " " + std::to_string(point + 1);
  EXPECT_EQ(message_of(raw).substr(0, message_of(raw).find(", centroid")),
            "cube.ele:5: cell 4: volume -0.166667 is not positive (vertices" + vertices);
  EXPECT_NE(message_of(raw).find("); check node order"), std::string::npos);
}

TEST(MeshFaults, NameTheInvertedCellsEvenWhereTheyAreMost) {
  RawMesh raw = kuhn_cube_raw();
  for (auto& cell : raw.cells) std::swap(cell[0], cell[1]);
  std::swap(raw.cells[2][0], raw.cells[2][1]);
  const std::string message = message_of(raw);
  EXPECT_EQ(message.find("cell 0: volume -0.166667 is not positive"), 0u) << message;
  EXPECT_EQ(message.find("cell 2:"), std::string::npos) << message;
}

TEST(MeshFaults, AreNoneWhereAllCellsAreNumberedTheOtherWayRound) {
  RawMesh raw = kuhn_cube_raw();
  for (auto& cell : raw.cells) std::swap(cell[0], cell[1]);
  const TetrahedralMesh mesh(raw);
  for (const double volume : mesh.volumes()) EXPECT_NEAR(volume, 1.0 / 6, 1e-15);
}

TEST(MeshFaults, NameTheFlatCell) {
  RawMesh raw = single_tetrahedron_raw();
  raw.points[3] = {1, 1, 0};
  EXPECT_EQ(
      message_of(raw),
      "cell 0: volume 0 is not positive (vertices 0 1 2 3, centroid (0.5, 0.5, 0)); remove the flat cell");
}

TEST(MeshFaults, NameTheCellThatUsesAPointTwice) {
  RawMesh raw = single_tetrahedron_raw();
  raw.cells[0] = {0, 1, 2, 2};
  EXPECT_EQ(message_of(raw).find("cell 0: volume 0 is not positive (vertices 0 1 2 2"), 0u);
}

TEST(MeshFaults, KeepTheFirstFewOfManyFaults) {
  RawMesh raw;
  raw.region_names = {"domain"};
  raw.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  raw.cells.assign(12, {0, 1, 2, 3});
  raw.cell_regions.assign(12, 0);
  const std::string message = message_of(raw);
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 4);
  EXPECT_NE(message.find("(and 7 more of this kind)"), std::string::npos) << message;
}

TEST(MeshFaults, NameTheFaceOfThreeCells) {
  RawMesh raw = two_tetrahedra({1, 1, 1});
  raw.points.emplace_back(2, 1.5, 1.5);
  raw.cells.push_back({1, 2, 3, 5});
  raw.cell_regions.push_back(0);
  EXPECT_EQ(
      message_of(raw),
      "face of vertices 1 2 3 at (0.333333, 0.333333, 0.333333), cells 0 1 2: shared by 3 cells; a face "
      "has at most two; remove duplicate cells");
}

TEST(MeshFaults, NameTheFaceOfOverlappingCells) {
  RawMesh raw = two_tetrahedra({0.1, 0.1, 0.2});
  std::swap(raw.cells[1][0], raw.cells[1][1]);
  EXPECT_EQ(message_of(raw),
            "face of vertices 1 2 3 at (0.333333, 0.333333, 0.333333), cells 0 1: both cells lie on the same "
            "side of it (they overlap); remove one or check node order");
}

TEST(MeshFaults, NameTheHangingVertex) {
  // The second cell stands on half of the first one's slanted face: point 4 lies on an edge of it.
  RawMesh raw = single_tetrahedron_raw();
  raw.points.emplace_back(0.5, 0.5, 0);
  raw.points.emplace_back(1, 1, 1);
  raw.cells.push_back({1, 4, 3, 5});
  raw.cell_regions.push_back(0);
  const std::string message = message_of(raw);
  EXPECT_EQ(message.find("face of vertices "), 0u);
  EXPECT_NE(
      message.find("vertex 4 at (0.5, 0.5, 0) lies on it without being one of its corners (the mesh does "
                   "not conform); cells must share whole faces"),
      std::string::npos)
      << message;
}

TEST(MeshFaults, NameTheVertexInsideAFace) {
  RawMesh raw = single_tetrahedron_raw();
  raw.points.emplace_back(0.2, 0.3, 0);
  raw.points.emplace_back(0.2, 0.2, -1);
  raw.points.emplace_back(0.3, 0.2, -1);
  raw.points.emplace_back(0.2, 0.4, -1.5);
  raw.cells.push_back({4, 6, 5, 7});
  raw.cell_regions.push_back(0);
  EXPECT_NE(message_of(raw).find("vertex 4 at (0.2, 0.3, 0) lies on it"), std::string::npos)
      << message_of(raw);
}

TEST(MeshFaults, NameFacesThatCoverEachOther) {
  // Two cubes of six cells side by side whose common side is cut along different diagonals.
  RawMesh raw = kuhn_cube_raw();
  raw.triangles.clear();
  raw.triangle_walls.clear();
  std::array<int, 8> mirrored{};
  for (int i = 0; i < 8; ++i) {
    // Corner i of the second cube, mirrored in y, at x from 1 to 2.
    Vec3 p = raw.points[static_cast<std::size_t>(i)];
    p.y() = 1 - p.y();
    p.x() += 1;
    int found = -1;
    for (std::size_t q = 0; q < raw.points.size(); ++q)
      if (raw.points[q] == p) found = static_cast<int>(q);
    if (found < 0) {
      found = static_cast<int>(raw.points.size());
      raw.points.push_back(p);
    }
    mirrored[static_cast<std::size_t>(i)] = found;
  }
  for (std::size_t c = 0; c < 6; ++c) {
    auto cell = raw.cells[c];
    for (int& point : cell) point = mirrored[static_cast<std::size_t>(point)];
    std::swap(cell[2], cell[3]);
    raw.cells.push_back(cell);
    raw.cell_regions.push_back(0);
  }
  EXPECT_NE(
      message_of(raw).find("the boundary faces of two cells cover each other (the mesh does not conform); "
                           "cells must share whole faces"),
      std::string::npos)
      << message_of(raw);
}

TEST(MeshFaults, NamePointsThatCoincide) {
  RawMesh raw = two_tetrahedra({1, 1, 1});
  raw.points.push_back(raw.points[3]);
  raw.cells[1] = {1, 2, 5, 4};
  EXPECT_EQ(
      message_of(raw),
      "points 3 and 5 are both at (0, 0, 1) (the cells around them are not connected); merge coincident "
      "points");
}

TEST(MeshFaults, NameTheBoundaryFaceWithoutWall) {
  RawMesh raw = kuhn_cube_raw();
  raw.triangles.pop_back();
  raw.triangle_walls.pop_back();
  const std::string message = message_of(raw);
  EXPECT_EQ(message.find("face of vertices "), 0u);
  EXPECT_NE(
      message.find(": boundary face has no wall name although others have one; name every boundary face, "
                   "or none"),
      std::string::npos)
      << message;
}

TEST(MeshFaults, NameTheTriangleThatIsNoFace) {
  RawMesh raw = kuhn_cube_raw();
  raw.triangles.push_back({0, 3, 5});
  raw.triangle_walls.push_back(2);
  EXPECT_EQ(
      message_of(raw),
      "face of vertices 0 3 5 at (0.666667, 0.333333, 0.333333): triangle of wall \"ymin\" is no face of a "
      "tetrahedron; walls must be faces of the mesh");
}

TEST(MeshFaults, NameTheFaceOfTwoWalls) {
  RawMesh raw = kuhn_cube_raw();
  raw.triangles.push_back(raw.triangles[0]);
  raw.triangle_walls.push_back(3);
  EXPECT_NE(message_of(raw).find(": belongs to both walls \"xmin\" and \"ymax\"; a face has one wall"),
            std::string::npos)
      << message_of(raw);
}

TEST(MeshFaults, NameThePointThatIsNotFinite) {
  RawMesh raw = single_tetrahedron_raw();
  raw.points[2].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of(raw), "point 2: coordinates (0, nan, 0) are not finite; use numbers below 1e100");
  raw.points[2].y() = 1e200;
  EXPECT_EQ(message_of(raw), "point 2: coordinates (0, 1e+200, 0) are not finite; use numbers below 1e100");
}

TEST(MeshFaults, NameIndicesThatDoNotExist) {
  RawMesh raw = single_tetrahedron_raw();
  raw.cells[0][1] = 4;
  EXPECT_EQ(message_of(raw), "cell 0: point 4 does not exist; there are 4");
  raw.cells[0][1] = -1;
  EXPECT_EQ(message_of(raw), "cell 0: point -1 does not exist; there are 4");
  raw = single_tetrahedron_raw();
  raw.cell_regions[0] = 1;
  EXPECT_EQ(message_of(raw), "cell 0: region does not exist");
  raw = kuhn_cube_raw();
  raw.triangles[1][0] = 8;
  EXPECT_EQ(message_of(raw), "triangle 1: point 8 does not exist; there are 8");
  raw = kuhn_cube_raw();
  raw.triangle_walls[2] = 6;
  EXPECT_EQ(message_of(raw), "triangle 2: wall does not exist");
}

TEST(MeshFaults, SayThatThereAreNoCells) {
  RawMesh raw;
  raw.file = "empty.msh";
  EXPECT_EQ(message_of(raw), "empty.msh: no tetrahedra (a volume mesh is needed); mesh the volume");
}

}  // namespace
}  // namespace etendue::mesh_faults_test
