// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/search/ray_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "mesh/tetrahedra/search/cell_locator.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::ray_mesh_test {
namespace {

constexpr double far = std::numeric_limits<double>::infinity();

struct Path {
  double length = 0;
  std::vector<CellIndex> cells;
  RayEnd end;
};

Path walk(const RayMesh& rays, CellIndex cell, const Vec3& from, const Vec3& direction, double length = far) {
  Path path;
  path.end = rays.walk(cell, from, direction, length, [&](CellIndex at, double part) {
    EXPECT_GE(part, 0);
    path.length += part;
    path.cells.push_back(at);
  });
  return path;
}

/// Way from a point in the unit cube to its boundary.
double distance_out(const Vec3& from, const Vec3& direction) {
  double path_length = far;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] > 0) path_length = std::min(path_length, (1 - from[axis]) / direction[axis]);
    if (direction[axis] < 0) path_length = std::min(path_length, -from[axis] / direction[axis]);
  }
  return path_length;
}

Vec3 random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vec3(normal(random), normal(random), normal(random)).normalized();
}

TetrahedralMesh crate_mesh(const Vec3& low, const Vec3& high) {
  Geometry geometry;
  BoxPrimitive room;
  room.region = "room";
  geometry.primitives.emplace_back(room);
  BoxPrimitive crate;
  crate.min = low;
  crate.max = high;
  crate.hole = true;
  crate.name = "crate";
  geometry.primitives.emplace_back(crate);
  return TetrahedralMesh(tetrahedralize(arrange(geometry), {{0.01}, 1.4, {}}));
}

TEST(RayMesh, CoversTheWayToTheBoundary) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  const RayMesh rays(mesh);
  std::mt19937 random(1);
  std::uniform_int_distribution<int> any_cell(0, mesh.cell_count() - 1);
  for (int i = 0; i < 20000; ++i) {
    const CellIndex cell(any_cell(random));
    const Vec3 from = mesh.centroid(cell);
    const Vec3 direction = random_direction(random);
    const Path path = walk(rays, cell, from, direction);
    ASSERT_TRUE(path.end.wall);
    ASSERT_NEAR(path.length, distance_out(from, direction), 1e-10);
    ASSERT_LT((mesh.centroid(*path.end.wall) - from).cross(direction).norm(), 1);
    ASSERT_EQ(mesh.owner(*path.end.wall), path.cells.back());
  }
}

TEST(RayMesh, PassesTheCellsThatItNames) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  const RayMesh rays(mesh);
  const CellLocator locator(mesh);
  std::mt19937 random(2);
  for (int i = 0; i < 300; ++i) {
    const Vec3 from = mesh.centroid(CellIndex(i % mesh.cell_count()));
    const Vec3 direction = random_direction(random);
    double path_length = 0;
    rays.walk(CellIndex(i % mesh.cell_count()), from, direction, far, [&](CellIndex cell, double part) {
      if (part > 1e-9) {
        bool holds = false;
        for (const CellPoint& at : locator.find(from + (path_length + part / 2) * direction))
          holds = holds || at.cell == cell;
        EXPECT_TRUE(holds);
      }
      path_length += part;
    });
  }
}

// From a wall to one nearby the path is as long as it is, however large the cells are.
TEST(RayMesh, KeepsShortWaysInLongCells) {
  const TetrahedralMesh mesh = cube_mesh(1e12, 1e4);
  const RayMesh rays(mesh);
  const CellLocator locator(mesh);
  for (const double distance : {1.0, 10.0, 1000.0})
    for (const double y : {1234.5, 5000.0}) {
      const Vec3 from(distance, y, 0);
      for (const CellPoint& at : locator.find(from)) {
        const Path path = walk(rays, at.cell, from, -Vec3::UnitX());
        EXPECT_NEAR(path.length, distance, 1e-10);
      }
    }
}

TEST(RayMesh, StopsAtItsLength) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  const RayMesh rays(mesh);
  const Vec3 from = mesh.centroid(CellIndex(0));
  const Vec3 direction = (Vec3(0.5, 0.5, 0.5) - from).normalized();
  const Path path = walk(rays, CellIndex(0), from, direction, 0.3);
  EXPECT_FALSE(path.end.wall);
  EXPECT_NEAR(path.length, 0.3, 1e-11);
}

// Rays of the cube cut along its diagonal lie in faces and edges, and go through vertices.
TEST(RayMesh, FollowsFacesEdgesAndVertices) {
  const TetrahedralMesh mesh{kuhn_cube_raw()};
  const RayMesh rays(mesh);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (const std::int32_t v : mesh.vertices(CellIndex(c)))
      for (int d = 0; d < 27; ++d) {
        if (d == 13) continue;
        const Vec3 direction = Vec3(d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1).normalized();
        const Path path = walk(rays, CellIndex(c), mesh.point(VertexIndex(v)), direction);
        EXPECT_TRUE(path.end.wall);
        EXPECT_NEAR(path.length, distance_out(mesh.point(VertexIndex(v)), direction), 1e-10);
      }
}

TEST(RayMesh, StartsAtVerticesEdgesAndFaces) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  const RayMesh rays(mesh);
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const auto& v = mesh.vertices(CellIndex(c));
    const Vec3 a = mesh.point(VertexIndex(v[0])), b = mesh.point(VertexIndex(v[1])),
               e = mesh.point(VertexIndex(v[2]));
    for (const Vec3& from : {a, Vec3((a + b) / 2), Vec3((a + b + e) / 3)}) {
      const Vec3 to = mesh.point(VertexIndex((c * 37) % mesh.vertex_count()));
      const double distance = (to - from).norm();
      if (distance < 1e-6) continue;
      const Path path = walk(rays, CellIndex(c), from, (to - from) / distance);
      EXPECT_NEAR(path.length, distance_out(from, (to - from) / distance), 1e-9);
      EXPECT_EQ(std::set<CellIndex>(path.cells.begin(), path.cells.end()).size(), path.cells.size());
    }
  }
}

TEST(RayMesh, PassesAsMuchOfEachCellOnTheWayBack) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  const RayMesh rays(mesh);
  const auto parts = [&](CellIndex cell, const Vec3& from, const Vec3& to) {
    std::vector<double> lengths(static_cast<std::size_t>(mesh.cell_count()), 0);
    rays.walk(cell, from, (to - from).normalized(), (to - from).norm(),
              [&](CellIndex at, double part) { lengths[at.at()] += part; });
    return lengths;
  };
  const Vec3 from = mesh.centroid(CellIndex(0));
  for (std::int32_t c = 1; c < mesh.cell_count(); c += 7) {
    const Vec3 to = mesh.centroid(CellIndex(c));
    const std::vector<double> there = parts(CellIndex(0), from, to), back = parts(CellIndex(c), to, from);
    for (std::size_t i = 0; i < there.size(); ++i) EXPECT_NEAR(there[i], back[i], 1e-9);
  }
}

TEST(RayMesh, StaysOutOnceItHasLeft) {
  const TetrahedralMesh mesh = crate_mesh({0.4, 0.4, 0.4}, {0.6, 0.6, 0.6});
  const RayMesh rays(mesh);
  const Vec3 from(0.1, 0.47, 0.52);
  const Path path = walk(rays, CellLocator(mesh).find(from)[0].cell, from, Vec3::UnitX());
  ASSERT_TRUE(path.end.wall);
  EXPECT_EQ(mesh.wall_names()[static_cast<std::size_t>(mesh.wall(*path.end.wall))], "crate.xmin");
  EXPECT_NEAR(path.length, 0.3, 1e-10);
}

// Two cubes, one above the other.
TEST(RayMesh, SeesAGapOfAMillionth) {
  RawMesh raw = kuhn_cube_raw();
  const RawMesh lower = raw;
  for (const Vec3& point : lower.points) raw.points.emplace_back(point + Vec3(0, 0, 1 + 1e-6));
  const auto shift = static_cast<std::int32_t>(lower.points.size());
  for (auto cell : lower.cells) {
    for (auto& vertex : cell) vertex += shift;
    raw.cells.push_back(cell);
  }
  for (auto face : lower.triangles) {
    for (auto& vertex : face) vertex += shift;
    raw.triangles.push_back(face);
  }
  raw.cell_regions.insert(raw.cell_regions.end(), lower.cell_regions.begin(), lower.cell_regions.end());
  raw.triangle_walls.insert(raw.triangle_walls.end(), lower.triangle_walls.begin(),
                            lower.triangle_walls.end());
  const TetrahedralMesh mesh(raw);
  const RayMesh rays(mesh);
  const CellLocator locator(mesh);
  for (int i = 0; i < 400; ++i) {
    const Vec3 from(0.03 + 0.049 * (i % 20), 0.03 + 0.049 * (i / 20), 0.1);
    EXPECT_NEAR(walk(rays, locator.find(from)[0].cell, from, Vec3::UnitZ()).length, 0.9, 1e-10);
  }
}

}  // namespace
}  // namespace etendue::ray_mesh_test
