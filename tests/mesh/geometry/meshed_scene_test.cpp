// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "tests/mesh/geometry/scene.h"
#include "tests/mesh/geometry/surface_measures.h"

namespace etendue::meshed_scene_test {
namespace {

using Sums = std::map<std::string, double>;

struct Measures {
  Sums volumes;  ///< by region
  Sums areas;    ///< by wall
};

Measures measures(const RawMesh& mesh) {
  Measures sums;
  const auto point = [&](int i) { return mesh.points.at(static_cast<std::size_t>(i)); };
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const auto [a, b, c, d] = mesh.cells[i];
    sums.volumes[mesh.region_names.at(static_cast<std::size_t>(mesh.cell_regions[i]))] +=
        std::abs((point(b) - point(a)).cross(point(c) - point(a)).dot(point(d) - point(a))) / 6;
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    sums.areas[mesh.wall_names.at(static_cast<std::size_t>(mesh.triangle_walls[i]))] +=
        (point(b) - point(a)).cross(point(c) - point(a)).norm() / 2;
  }
  return sums;
}

Measures meshed(const Geometry& geometry) { return measures(tetrahedralize(arrange(geometry), {})); }

void expect_near(const Sums& sums, const Sums& expected) {
  ASSERT_EQ(sums.size(), expected.size());
  for (const auto& [name, value] : expected) {
    ASSERT_TRUE(sums.contains(name)) << name;
    EXPECT_NEAR(sums.at(name), value, 1e-12 * value) << name;
  }
}

/// The meshed walls are the walls of the arrangement, whatever the scene.
void expect_same_walls(const Geometry& geometry) {
  const SurfaceComplex surface = arrange(geometry);
  Sums expected = wall_areas(surface);
  expected.erase("");
  expect_near(measures(tetrahedralize(surface, {})).areas, expected);
}

TEST(MeshedScene, NestedTouchingAndHollowBoxesKeepVolumesAndAreas) {
  const Geometry geometry{
      {named(box("air", {0, 0, 0}, {4, 3, 2.5}), {{"zmin", "floor"}, {"zmax", "ceiling"}}),
       box("table", {0.3, 0.3, 0}, {1.1, 1.2, 0.7}), box("cup", {0.5, 0.5, 0.7}, {0.6, 0.6, 0.9}),
       box_hole("crate", {2, 1, 0}, {3, 2, 0.8}), box("annex", {4, 0.5, 0}, {5, 1.5, 2})},
      {patch("lamp", {1.5, 1, 2.5}, {2.5, 2, 2.5})}};
  const Measures sums = meshed(geometry);
  expect_near(sums.volumes, {{"air", 30 - 0.8 * 0.9 * 0.7 - 0.002 - 0.8},
                             {"table", 0.8 * 0.9 * 0.7},
                             {"cup", 0.002},
                             {"annex", 2}});
  expect_near(sums.areas, {{"floor", 11},
                           {"zmin", 1},
                           {"ceiling", 11},
                           {"lamp", 1},
                           {"zmax", 1},
                           {"xmin", 7.5},
                           {"xmax", 7.5 - 2 + 2},
                           {"ymin", 10 + 2},
                           {"ymax", 10 + 2},
                           {"crate.xmin", 0.8},
                           {"crate.xmax", 0.8},
                           {"crate.ymin", 0.8},
                           {"crate.ymax", 0.8},
                           {"crate.zmax", 1}});
}

TEST(MeshedScene, OverlappingBoxesKeepVolumes) {
  expect_near(meshed({{box("a", {0, 0, 0}, {2, 2, 2}), box("b", {1, 1, 1}, {3, 3, 3})}, {}}).volumes,
              {{"a", 7}, {"b", 8}});
}

TEST(MeshedScene, BallThatTouchesAllSidesOfItsBoxLeavesTheCorners) {
  const auto volumes = meshed({{box("room", {-2, -2, -2}, {2, 2, 2}), box("box", {-1, -1, -1}, {1, 1, 1}),
                                sphere("ball", {0, 0, 0}, 1)},
                               {}})
                           .volumes;
  ASSERT_EQ(volumes.size(), 3u);
  EXPECT_NEAR(volumes.at("room"), 56, 1e-12 * 56);
  EXPECT_NEAR(volumes.at("box") + volumes.at("ball"), 8, 1e-12 * 8);
}

TEST(MeshedScene, DisjointBoxesAreMeshedEach) {
  expect_near(meshed({{box("a", {0, 0, 0}, {1, 1, 1}), box("a", {2, 0, 0}, {3, 2, 1})}, {}}).volumes,
              {{"a", 3}});
}

TEST(MeshedScene, BoxesThatTouchInAnEdgeOrVertexAreMeshed) {
  expect_near(meshed({{box("a", {0, 0, 0}, {1, 1, 1}), box("b", {1, 1, 0}, {2, 2, 1})}, {}}).volumes,
              {{"a", 1}, {"b", 1}});
  expect_near(meshed({{box("a", {0, 0, 0}, {1, 1, 1}), box("b", {1, 1, 1}, {2, 2, 2})}, {}}).volumes,
              {{"a", 1}, {"b", 1}});
}

TEST(MeshedScene, RegionInsideAHoleIsMeshed) {
  expect_near(meshed({{box("air", {0, 0, 0}, {5, 5, 5}), box_hole("crate", {1, 1, 1}, {4, 4, 4}),
                       box("inside", {2, 2, 2}, {3, 3, 3})},
                      {}})
                  .volumes,
              {{"air", 98}, {"inside", 1}});
}

TEST(MeshedScene, LampInTheMiddleOfARoomKeepsTheWallsCoarse) {
  const RawMesh mesh = tetrahedralize(
      arrange({{box("air", {0, 0, 0}, {10, 10, 10}), box("lamp", {4, 4, 4}, {6, 6, 6})}, {}}), {});
  EXPECT_LT(mesh.cells.size(), 400u);
}

TEST(MeshedScene, SphereAndShellKeepInscribedVolume) {
  const Measures sums = meshed({{box("air", {-2, -2, -2}, {2, 2, 2}), sphere("shell", {0, 0, 0}, 1, 320),
                                 sphere("core", {0, 0, 0}, 0.5, 320)},
                                {}});
  EXPECT_NEAR(sums.volumes.at("shell"), 7 * sums.volumes.at("core"), 1e-12);
  EXPECT_NEAR(sums.volumes.at("air") + sums.volumes.at("shell") + sums.volumes.at("core"), 64, 1e-11);
  const double ball = 4 * std::numbers::pi / 3 / 8;
  EXPECT_LT(sums.volumes.at("core"), ball);
  EXPECT_GT(sums.volumes.at("core"), 0.95 * ball);
}

TEST(MeshedScene, SphereThatTouchesAWallInAVertexIsMeshed) {
  expect_same_walls({{box("air", {0, 0, 0}, {3, 3, 2}), sphere("ball", {1.5, 1.5, 1}, 1, 80)}, {}});
}

TEST(MeshedScene, CylinderThatLiesOnTheFloorIsMeshed) {
  expect_same_walls(
      {{box("air", {0, 0, 0}, {4, 4, 2}), cylinder("pipe", {2, 1, 0.5}, {2, 3, 0.5}, 0.5, 8)}, {}});
  expect_same_walls({{box("air", {0, 0, 0}, {4, 4, 2}), cylinder("pipe", {2, 0, 1}, {2, 4, 1}, 1, 8)}, {}});
}

TEST(MeshedScene, SphereAcrossAWallIsMeshed) {
  expect_same_walls({{box("air", {0, 0, 0}, {3, 3, 2}), sphere("ball", {1.5, 1.5, 2}, 0.7, 80)}, {}});
  expect_same_walls({{box("air", {0, 0, 0}, {3, 3, 2}), sphere_hole("ball", {3, 1.5, 2}, 0.7, 80)}, {}});
}

TEST(MeshedScene, CrossingBodiesAreMeshed) {
  const Geometry geometry{
      {box("air", {0, 0, 0}, {4, 4, 4}), sphere("fog", {2, 2, 2}, 1.2, 80),
       sphere_hole("stone", {2.7, 2.1, 2}, 0.9, 80), cylinder("jet", {1, 1, 0.5}, {3.3, 3.1, 5}, 0.4, 9),
       box("slab", {0, 0, 1.5}, {4, 4, 1.75})},
      {}};
  expect_same_walls(geometry);
}

TEST(MeshedScene, PillarAndLyingCylinderAreMeshed) {
  const Geometry geometry{
      {box("air", {0, 0, 0}, {4, 4, 3}), cylinder_hole("pillar", {1, 1, 0}, {1, 1, 3}, 0.4, 16),
       cylinder("pipe", {0, 3, 1}, {4, 3, 1}, 0.3, 16)},
      {}};
  const Measures sums = meshed(geometry);
  const double pipe = 4 * 16 * 0.5 * 0.09 * std::sin(std::numbers::pi / 8);
  const double pillar = 3 * 16 * 0.5 * 0.16 * std::sin(std::numbers::pi / 8);
  expect_near(sums.volumes, {{"pipe", pipe}, {"air", 48 - pipe - pillar}});
}

TEST(MeshedScene, OverlappingEqualSpheresAreMeshed) {
  const Measures sums = meshed({{sphere("a", {2, 2, 2}, 1.2, 80), sphere("b", {2.5, 2, 2}, 1.2, 80)}, {}});
  const Measures alone = meshed({{sphere("b", {2.5, 2, 2}, 1.2, 80)}, {}});
  EXPECT_NEAR(sums.volumes.at("b"), alone.volumes.at("b"), 1e-12);
}

TEST(MeshedScene, ManyBoxesAreArrangedAtOnce) {
  Geometry geometry{{box("air", {0, 0, 0}, {21, 21, 21})}, {}};
  for (int i = 0; i < 20; ++i) {
    const double at = i + 0.03 * i * (i % 5 + 1) / 5;
    geometry.primitives.push_back(box("brick", {at, 0.5 + i / 2.0, 1}, {at + 0.5, 1 + i / 2.0, 20}));
  }
  const Measures sums = meshed(geometry);
  expect_near(sums.volumes, {{"air", 21.0 * 21 * 21 - 20 * 0.25 * 19}, {"brick", 20 * 0.25 * 19}});
}

}  // namespace
}  // namespace etendue::meshed_scene_test
