// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/arrangement/body_arrangement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/geometry/arrangement/box_arrangement.h"
#include "tests/mesh/geometry/scene.h"
#include "tests/mesh/geometry/surface_measures.h"

namespace etendue::body_arrangement_test {
namespace {

using Counts = std::map<std::string, int>;

/// Up to five boxes and holes on a coarse grid: they touch, nest and overlap in every way.
Geometry random_boxes(std::mt19937& random) {
  const auto pick = [&](int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); };
  Geometry geometry;
  const int count = pick(1, 5);
  for (int i = 0; i < count; ++i) {
    Vec3 min, max;
    for (int axis = 0; axis < 3; ++axis) {
      min[axis] = pick(0, 3);
      max[axis] = pick(static_cast<int>(min[axis]) + 1, 4);
    }
    const bool is_hole = i > 0 && pick(0, 3) == 0;
    BoxPrimitive one = is_hole ? box_hole("hole" + std::to_string(i), min, max)
                               : box(std::string(1, "abc"[pick(0, 2)]), min, max);
    if (!is_hole && pick(0, 1) == 0) one.walls["zmin"] = "floor" + std::to_string(i);
    geometry.primitives.push_back(one);
  }
  return geometry;
}

TEST(BodyArrangement, AgreesWithTheGridOnRandomBoxes) {
  std::mt19937 random(1);
  for (int scene = 0; scene < 40; ++scene) {
    const Geometry geometry = random_boxes(random);
    const SurfaceComplex by_grid = arrange_boxes(geometry), by_planes = arrange_bodies(geometry);
    const auto expected = wall_areas(by_grid), areas = wall_areas(by_planes);
    ASSERT_EQ(areas.size(), expected.size()) << scene;
    for (const auto& [name, area] : expected) ASSERT_NEAR(areas.at(name), area, 1e-12) << scene << name;
    ASSERT_EQ(by_planes.facets.size(), by_grid.facets.size()) << scene;
    ASSERT_EQ(by_planes.points.size(), by_grid.points.size()) << scene;
    ASSERT_EQ(seed_counts(by_planes), seed_counts(by_grid)) << scene;
    ASSERT_EQ(by_planes.holes.size(), by_grid.holes.size()) << scene;
  }
}

TEST(BodyArrangement, SphereInARoomIsAnInterface) {
  const SurfaceComplex surface =
      arrange({{box("air", {0, 0, 0}, {4, 3, 2.5}), sphere("smoke", {2, 1.5, 1}, 0.6)}, {}});
  EXPECT_EQ(surface.facets.size(), 6u + 320u);
  EXPECT_EQ(surface.points.size(), 8u + 162u);
  EXPECT_EQ(seed_counts(surface), (Counts{{"air", 1}, {"smoke", 1}}));
  EXPECT_TRUE(surface.holes.empty());
  const double area = wall_areas(surface).at("");
  EXPECT_LT(area, 4 * std::numbers::pi * 0.36);
  EXPECT_GT(area, 4 * std::numbers::pi * 0.36 * 0.97);
}

TEST(BodyArrangement, SphereTakesTheNearestNumberOfTriangles) {
  EXPECT_EQ(arrange({{sphere("a", {0, 0, 0}, 1, 20)}, {}}).facets.size(), 20u);
  EXPECT_EQ(arrange({{sphere("a", {0, 0, 0}, 1, 49)}, {}}).facets.size(), 20u);
  EXPECT_EQ(arrange({{sphere("a", {0, 0, 0}, 1, 51)}, {}}).facets.size(), 80u);
  EXPECT_EQ(arrange({{sphere("a", {0, 0, 0}, 1, 500)}, {}}).facets.size(), 500u);
}

TEST(BodyArrangement, SphereVerticesLieOnTheSphere) {
  const Vec3 center(1, 2, 3);
  for (const Vec3& point : arrange({{sphere("a", center, 0.7, 180)}, {}}).points)
    EXPECT_NEAR((point - center).norm(), 0.7, 1e-14);
}

TEST(BodyArrangement, CylinderIsARegularPrism) {
  const SurfaceComplex surface = arrange({{cylinder("a", {1, 1, 0}, {1, 1, 2}, 0.5, 12)}, {}});
  EXPECT_EQ(surface.facets.size(), 2u + 12u * 2u);
  EXPECT_EQ(surface.points.size(), 24u);
  const double ring = 12 * 0.5 * 0.25 * std::sin(std::numbers::pi / 6);
  EXPECT_NEAR(wall_areas(surface).at("zmax"), ring, 1e-14);
  EXPECT_NEAR(wall_areas(surface).at("zmin"), ring, 1e-14);
}

TEST(BodyArrangement, RoundHoleHasOneWallAndAHolePoint) {
  const SurfaceComplex surface =
      arrange({{box("air", {0, 0, 0}, {2, 2, 2}), sphere_hole("ball", {1, 1, 1}, 0.5, 80)}, {}});
  EXPECT_EQ(surface.wall_names.size(), 7u);
  EXPECT_TRUE(wall_areas(surface).contains("ball"));
  ASSERT_EQ(surface.holes.size(), 1u);
  EXPECT_LT((surface.holes.front() - Vec3(1, 1, 1)).norm(), 0.5);
  EXPECT_EQ(seed_counts(surface), (Counts{{"air", 1}}));
}

TEST(BodyArrangement, PillarFromFloorToCeilingOpensBoth) {
  const SurfaceComplex surface = arrange({{named(box("air", {0, 0, 0}, {4, 4, 3}), {{"zmin", "floor"}}),
                                           cylinder_hole("pillar", {2, 2, 0}, {2, 2, 3}, 1, 8)},
                                          {}});
  const double ring = 8 * 0.5 * std::sin(std::numbers::pi / 4);
  const auto areas = wall_areas(surface);
  EXPECT_NEAR(areas.at("floor"), 16 - ring, 1e-13);
  EXPECT_NEAR(areas.at("zmax"), 16 - ring, 1e-13);
  EXPECT_NEAR(areas.at("pillar"), 8 * 3 * 2 * std::sin(std::numbers::pi / 8), 1e-12);
  EXPECT_TRUE(surface.holes.empty());
}

TEST(BodyArrangement, LaterBoxCutsAnEarlierSphere) {
  const Geometry geometry{{sphere("ball", {0, 0, 0}, 1, 80), box("half", {-2, -2, 0}, {2, 2, 2})}, {}};
  const SurfaceComplex surface = arrange(geometry);
  EXPECT_EQ(seed_counts(surface), (Counts{{"ball", 1}, {"half", 1}}));
  const auto areas = wall_areas(surface);
  EXPECT_NEAR(areas.at("zmax"), 16, 1e-12);
  EXPECT_NEAR(areas.at("xmin"), areas.at("xmax"), 1e-12);
}

TEST(BodyArrangement, SphereOutsideTheBoxBelongsToTheDomain) {
  const SurfaceComplex surface =
      arrange({{box("air", {-1, -1, -1}, {1, 1, 1}), sphere("bulge", {0, 0, 1}, 0.5, 80)}, {}});
  EXPECT_EQ(seed_counts(surface), (Counts{{"air", 1}, {"bulge", 1}}));
  // The facets of the bulge count to the wall of their outward axis.
  EXPECT_GT(wall_areas(surface).at("xmax"), 4);
  EXPECT_EQ(surface.wall_names.size(), 6u);
}

TEST(BodyArrangement, CrossingBodiesHaveAClosedSurface) {
  // Every edge of the boundary bounds an even number of wall facets.
  const Geometry geometry{
      {box("air", {0, 0, 0}, {4, 4, 4}), sphere("fog", {2, 2, 2}, 1.2, 80),
       sphere_hole("stone", {2.7, 2.1, 2}, 0.9, 80), cylinder("jet", {1, 1, 0.5}, {3.3, 3.1, 5}, 0.4, 9),
       box("slab", {0, 0, 1.5}, {4, 4, 1.75})},
      {}};
  const SurfaceComplex surface = arrange(geometry);
  std::map<std::pair<int, int>, int> walls_at;
  for (const SurfaceFacet& facet : surface.facets)
    for (const std::vector<int>& polygon : facet.polygons)
      for (std::size_t i = 0; i < (polygon.size() == 2 ? 1 : polygon.size()); ++i)
        if (facet.wall >= 0) ++walls_at[std::minmax(polygon[i], polygon[(i + 1) % polygon.size()])];
  for (const auto& [edge, walls] : walls_at) EXPECT_EQ(walls % 2, 0);
  EXPECT_EQ(surface.holes.size(), 2u);  // the slab fills the middle of the stone
}

TEST(BodyArrangement, PatchCutsAWallThatASphereCrosses) {
  const Geometry geometry{{box("air", {0, 0, 0}, {2, 2, 2}), sphere_hole("dent", {1, 1, 2}, 0.5, 80)},
                          {patch("lamp", {1, 0, 2}, {2, 2, 2})}};
  const auto areas = wall_areas(arrange(geometry));
  EXPECT_NEAR(areas.at("lamp"), areas.at("zmax"), 1e-12);
  EXPECT_LT(areas.at("lamp"), 2);
}

TEST(BodyArrangement, RefusesRoundBodiesWithoutVolume) {
  EXPECT_EQ(fault_of({{sphere("a", {0, 0, 0}, -1)}, {}}),
            "case.toml:7: mesh.sphere = center [0, 0, 0], radius -1, facets 320: radius must be above 0 (the "
            "sphere has no volume)");
  EXPECT_EQ(
      fault_of({{sphere("a", {0, 0, 0}, 1, 8)}, {}}),
      "case.toml:7: mesh.sphere = center [0, 0, 0], radius 1, facets 8: facets must be at least 20 (the "
      "icosahedron)");
  EXPECT_EQ(
      fault_of({{cylinder("a", {0, 0, 1}, {0, 0, 1}, 1)}, {}}),
      "case.toml:7: mesh.cylinder = [0, 0, 1] to [0, 0, 1], radius 1, facets 32: from and to must differ "
      "(the cylinder has no length)");
  EXPECT_THAT(fault_of({{cylinder("a", {0, 0, 0}, {0, 0, 1}, 1, 2)}, {}}), testing::HasSubstr("at least 3"));
}

TEST(BodyArrangement, RefusesBodiesThatNearlyTouch) {
  EXPECT_THAT(
      fault_of({{box("air", {0, 0, 0}, {2, 2, 2}), cylinder("a", {1, 1, -1e-8}, {1, 1, 1}, 0.5, 8)}, {}}),
      testing::MatchesRegex("case.toml:7: mesh.cylinder: primitives cross within 1e-08 of each other near .* "
                            "\\(too close to be "
                            "meshed\\); let them overlap, part them or make their coordinates equal"));
}

TEST(BodyArrangement, VertexThatTouchesAWallIsAPointOfTheWall) {
  const SurfaceComplex surface =
      arrange({{box("air", {0, 0, 0}, {3, 3, 2}), sphere("ball", {1.5, 1.5, 1}, 1, 80)}, {}});
  std::size_t lone = 0;
  for (const SurfaceFacet& facet : surface.facets)
    for (const std::vector<int>& polygon : facet.polygons) lone += polygon.size() == 1;
  EXPECT_EQ(lone, 2u);
  EXPECT_EQ(seed_counts(surface), (Counts{{"air", 1}, {"ball", 1}}));
}

TEST(BodyArrangement, CylinderBetweenFloorAndCeilingPartsTheAir) {
  // It touches both in a line and reaches from wall to wall.
  const SurfaceComplex surface =
      arrange({{box("air", {0, 0, 0}, {4, 4, 2}), cylinder("pipe", {2, 0, 1}, {2, 4, 1}, 1, 8)}, {}});
  EXPECT_EQ(seed_counts(surface), (Counts{{"air", 2}, {"pipe", 1}}));
}

TEST(BodyArrangement, RoundingDoesNotPartWhatIsSymmetric) {
  // The vertices of the two balls mirror each other in the plane where they cross.
  const SurfaceComplex surface =
      arrange({{sphere("a", {2, 2, 2}, 1.2, 320), sphere("b", {2.5, 2, 2}, 1.2, 320)}, {}});
  EXPECT_EQ(seed_counts(surface), (Counts{{"a", 1}, {"b", 1}}));
}

TEST(BodyArrangement, RefusesAPatchOffTheBoundary) {
  EXPECT_THAT(fault_of({{box("air", {0, 0, 0}, {2, 2, 2}), sphere("a", {1, 1, 1}, 0.5)},
                        {patch("lamp", {0, 0, 1}, {2, 2, 1})}}),
              testing::HasSubstr("covers no boundary"));
}

}  // namespace
}  // namespace etendue::body_arrangement_test
