// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/geometry/primitives/sheet_shape.h"
#include "mesh/tetrahedra/adjacency/flat_neighbours.h"
#include "mesh/tetrahedra/generation/red_refinement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "tests/mesh/geometry/scene.h"

namespace etendue::sheet_test {
namespace {

Sheet sheet(const std::vector<Vec3>& corners, const std::string& front, const std::string& back) {
  return {corners, front, back, Origin{"case.toml", 40, "mesh.sheet[0]"}};
}

Sheet rectangle(const Vec3& min, const Vec3& max, const std::string& name) {
  return sheet(rectangle_corners(min, max), name + ".front", name + ".back");
}

Geometry room(std::vector<Sheet> sheets) {
  return {{box("air", {0, 0, 0}, {2, 2, 2})}, {}, std::move(sheets)};
}

TetrahedralMesh meshed(const Geometry& geometry) {
  return TetrahedralMesh(tetrahedralize(arrange(geometry), {{0.05}, 1.4, {}}));
}

struct WallSums {
  double area = 0;
  Vec3 outward = Vec3::Zero();  ///< area times normal out of the domain
};

std::map<std::string, WallSums> sums(const TetrahedralMesh& mesh) {
  std::map<std::string, WallSums> result;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    WallSums& wall = result[mesh.wall_names().at(static_cast<std::size_t>(mesh.wall(FaceIndex(f))))];
    wall.area += mesh.area(FaceIndex(f));
    wall.outward += mesh.area_normal(FaceIndex(f));
  }
  return result;
}

void expect_side(const TetrahedralMesh& mesh, const std::string& name, double area, const Vec3& inward) {
  const auto walls = sums(mesh);
  ASSERT_TRUE(walls.contains(name)) << name;
  EXPECT_NEAR(walls.at(name).area, area, 1e-12) << name;
  EXPECT_NEAR((walls.at(name).outward + area * inward).norm(), 0, 1e-12) << name;
}

double volume(const TetrahedralMesh& mesh) {
  double sum = 0;
  for (const double one : mesh.volumes()) sum += one;
  return sum;
}

TEST(Sheet, FloatingInARoomHasAWallOnEachSide) {
  const TetrahedralMesh mesh = meshed(room({rectangle({0.5, 0.5, 1}, {1.5, 1.25, 1}, "table")}));
  expect_side(mesh, "table.front", 0.75, Vec3::UnitZ());
  expect_side(mesh, "table.back", 0.75, -Vec3::UnitZ());
  EXPECT_NEAR(volume(mesh), 8, 1e-12);
}

TEST(Sheet, ItsCellsAreNotNeighbours) {
  const TetrahedralMesh mesh = meshed(room({rectangle({0, 0, 1}, {2, 2, 1}, "floor")}));
  for (std::int32_t f = mesh.boundary_face_count(); f < mesh.face_count(); ++f) {
    const FaceIndex face(f);
    EXPECT_EQ(mesh.centroid(mesh.owner(face)).z() < 1, mesh.centroid(mesh.neighbour(face)).z() < 1);
  }
}

TEST(Sheet, SplitsARoomIntoPartsThatBothHaveItsRegion) {
  const SurfaceComplex surface = arrange(room({rectangle({0, 0, 1}, {2, 2, 1}, "floor")}));
  EXPECT_EQ(surface.seeds.size(), 2u);
}

TEST(Sheet, EndsOnWallsAndOnOtherSheets) {
  // A shelf on a wall, a board below it that reaches the floor, and one through both.
  const TetrahedralMesh mesh = meshed(
      room({rectangle({0, 0.5, 1}, {1, 1.5, 1}, "shelf"), rectangle({0.5, 0.5, 0}, {0.5, 1.5, 1}, "board"),
            rectangle({0.25, 1, 0}, {0.75, 1, 1.5}, "cross")}));
  expect_side(mesh, "shelf.front", 1, Vec3::UnitZ());
  expect_side(mesh, "board.back", 1, -Vec3::UnitX());
  expect_side(mesh, "cross.front", 0.75, Vec3::UnitY());
  expect_side(mesh, "cross.back", 0.75, -Vec3::UnitY());
}

TEST(Sheet, PartsTheFloorAtItsFootAndNothingElse) {
  const TetrahedralMesh mesh = meshed(room({rectangle({1, 0.5, 0}, {1, 1.5, 1}, "board")}));
  const std::vector<std::array<std::int32_t, 3>> beyond = flat_neighbours(mesh);
  double foot = 0, rim = 0;  // length of the edges across which a face has no neighbour
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const FaceIndex face(f);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& a = mesh.point(VertexIndex(mesh.vertices(face)[i == 0 ? 1 : 0]));
      const Vec3& b = mesh.point(VertexIndex(mesh.vertices(face)[i == 2 ? 1 : 2]));
      if (const std::int32_t next = beyond[face.at()][i]; next >= 0) {
        EXPECT_NEAR(
            (mesh.area_normal(face).normalized() - mesh.area_normal(FaceIndex(next)).normalized()).norm(), 0,
            1e-12);
        continue;
      }
      const bool on_floor = mesh.centroid(face).z() < 1e-12;
      (on_floor && a.x() == 1 && b.x() == 1 ? foot : rim) += (b - a).norm();
    }
  }
  EXPECT_NEAR(foot, 2 * 1, 1e-12);                 // from both sides
  EXPECT_NEAR(rim, 6 * 4 * 2 + 2 * 4 * 1, 1e-12);  // of the sides of the room, and of both of the board
}

TEST(Sheet, OutsideAndInHolesIsNothing) {
  Geometry geometry = room({rectangle({1, -1, 1}, {3, 3, 1}, "board")});
  geometry.primitives.push_back(box_hole("crate", {1.5, 0.5, 0.5}, {1.75, 1, 1.5}));
  expect_side(meshed(geometry), "board.front", 2 - 0.25 * 0.5, Vec3::UnitZ());
}

TEST(Sheet, MayBeAnyPolygonInAnyPlane) {
  // An L, tilted about the x axis; its corners are in one plane to rounding only.
  const double c = std::cos(0.7), s = std::sin(0.7);
  std::vector<Vec3> corners;
  for (const auto& [u, v] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.4}, {0.4, 0.4}, {0.4, 1.0}, {0.0, 1.0}})
    corners.emplace_back(0.3 + u, 0.6 + c * v, 0.5 + s * v);
  const TetrahedralMesh mesh = meshed(room({sheet(corners, "up", "down")}));
  expect_side(mesh, "up", 0.64, {0, -s, c});
  expect_side(mesh, "down", 0.64, {0, s, -c});
}

TEST(Sheet, TiltedBetweenWallsMeetsThemExactly) {
  const std::vector<Vec3> roof{{0, 0, 0.7}, {2, 0, 1.3}, {2, 2, 1.3}, {0, 2, 0.7}};
  const TetrahedralMesh mesh = meshed(room({sheet(roof, "roof", "loft")}));
  expect_side(mesh, "roof", 2 * std::hypot(2, 0.6), Vec3(-0.6, 0, 2).normalized());
}

TEST(Sheet, CutsBallsAndInterfaces) {
  Geometry geometry = room({rectangle({0.2, 0.2, 1}, {1.8, 1.8, 1}, "board")});
  geometry.primitives.push_back(sphere("smoke", {1, 1, 1.2}, 0.5));
  geometry.primitives.push_back(box("water", {0, 0, 0}, {2, 2, 1}));
  expect_side(meshed(geometry), "board.front", 1.6 * 1.6, Vec3::UnitZ());
}

TEST(Sheet, KeepsItsSidesWhenCellsAreCutIntoEight) {
  const RawMesh raw = tetrahedralize(arrange(room({rectangle({0.5, 0.5, 1}, {1.5, 1.5, 1}, "table")})), {});
  const TetrahedralMesh mesh(red_refinement(raw));
  expect_side(mesh, "table.front", 1, Vec3::UnitZ());
  expect_side(mesh, "table.back", 1, -Vec3::UnitZ());
}

TEST(Sheet, RoomOfSheetsAloneHasAllWallsTwice) {
  const Vec3 a(0.5, 0.5, 0.5), b(1.5, 1.5, 1.5);
  std::vector<Sheet> quads;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool high : {false, true}) {
      Vec3 low = a, up = b;
      low[axis] = up[axis] = (high ? b : a)[axis];
      quads.push_back(rectangle(low, up, std::string(high ? "high" : "low") + "xyz"[axis]));
    }
  const TetrahedralMesh mesh = meshed(room(quads));
  for (int axis = 0; axis < 3; ++axis)
    for (const bool high : {false, true})
      for (const bool front : {false, true})
        expect_side(mesh, std::string(high ? "high" : "low") + "xyz"[axis] + (front ? ".front" : ".back"), 1,
                    (front ? 1 : -1) * Vec3::Unit(axis));
}

TEST(Sheet, FaultsSayWhatIsWrong) {
  const auto fault = [](const std::vector<Vec3>& corners) { return sheet_fault(sheet(corners, "a", "b")); };
  EXPECT_THAT(fault({{0, 0, 0}, {1, 0, 0}}), testing::HasSubstr("fewer than three corners"));
  EXPECT_THAT(fault({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), testing::HasSubstr("has no area"));
  EXPECT_THAT(fault({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}}), testing::HasSubstr("is not flat"));
  EXPECT_THAT(fault({{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {1, -1, 0}}),
              testing::HasSubstr("edges that cross or touch"));
  EXPECT_EQ(fault({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), "");
}

TEST(Sheet, OutsideTheDomainIsAFault) {
  EXPECT_THAT(
      fault_of(room({rectangle({3, 0, 0}, {4, 1, 0}, "far")})),
      testing::HasSubstr("case.toml:40: mesh.sheet[0]: sheet \"far.front\" from [3, 0, 0] lies nowhere"));
}

}  // namespace
}  // namespace etendue::sheet_test
