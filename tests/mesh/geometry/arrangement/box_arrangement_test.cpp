// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "mesh/geometry/arrangement/arrangement.h"
#include "tests/mesh/geometry/scene.h"
#include "tests/mesh/geometry/surface_measures.h"

namespace etendue::box_arrangement_test {
namespace {

using Areas = std::map<std::string, double>;
using Counts = std::map<std::string, int>;

void expect_areas(const SurfaceComplex& surface, const Areas& expected) {
  const Areas areas = wall_areas(surface);
  ASSERT_EQ(areas.size(), expected.size());
  for (const auto& [name, area] : expected) {
    ASSERT_TRUE(areas.contains(name)) << name;
    EXPECT_NEAR(areas.at(name), area, 1e-12 * area) << name;
  }
}

TEST(BoxArrangement, OneBoxHasSixSidesNamedByOutwardAxis) {
  const SurfaceComplex surface = arrange({{box("air", {0, 0, 0}, {4, 3, 2.5})}, {}});
  EXPECT_EQ(surface.facets.size(), 6u);
  EXPECT_EQ(surface.points.size(), 8u);
  expect_areas(surface,
               {{"xmin", 7.5}, {"xmax", 7.5}, {"ymin", 10}, {"ymax", 10}, {"zmin", 12}, {"zmax", 12}});
  EXPECT_EQ(seed_counts(surface), (Counts{{"air", 1}}));
  EXPECT_TRUE(surface.holes.empty());
}

TEST(BoxArrangement, CoordinatesAreThoseOfTheInput) {
  const Vec3 min(0.1, 0.2, 0.3), max(0.7, 1.1, 1.3);
  const SurfaceComplex surface = arrange({{box("air", min, max)}, {}});
  for (const Vec3& point : surface.points)
    for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(point[axis] == min[axis] || point[axis] == max[axis]);
}

TEST(BoxArrangement, TouchingBoxesShareOneInterface) {
  const SurfaceComplex surface =
      arrange({{box("a", {0, 0, 0}, {1, 1, 1}), box("b", {1, 0, 0}, {3, 1, 1})}, {}});
  expect_areas(surface,
               {{"", 1}, {"xmin", 1}, {"xmax", 1}, {"ymin", 3}, {"ymax", 3}, {"zmin", 3}, {"zmax", 3}});
  EXPECT_EQ(seed_counts(surface), (Counts{{"a", 1}, {"b", 1}}));
  EXPECT_EQ(surface.facets.size(), 11u);
}

TEST(BoxArrangement, BoxesOfOneRegionMelt) {
  const SurfaceComplex surface = arrange(
      {{box("a", {0, 0, 0}, {1, 1, 1}), box("a", {1, 0, 0}, {2, 1, 1}), box("a", {0.5, 0, 0}, {1.5, 1, 1})},
       {}});
  EXPECT_EQ(surface.facets.size(), 6u);
  EXPECT_EQ(surface.points.size(), 8u);
  EXPECT_EQ(seed_counts(surface), (Counts{{"a", 1}}));
}

TEST(BoxArrangement, LaterBoxOverwritesWhereTheyOverlap) {
  const SurfaceComplex surface =
      arrange({{box("a", {0, 0, 0}, {2, 2, 2}), box("b", {1, 1, 1}, {3, 3, 3})}, {}});
  // The corner of b inside a: three squares; the rest of both surfaces is outside.
  expect_areas(surface,
               {{"", 3}, {"xmin", 7}, {"xmax", 7}, {"ymin", 7}, {"ymax", 7}, {"zmin", 7}, {"zmax", 7}});
  EXPECT_EQ(seed_counts(surface), (Counts{{"a", 1}, {"b", 1}}));
}

TEST(BoxArrangement, NestedBoxIsAnInterfaceOfItsOwn) {
  const SurfaceComplex surface =
      arrange({{box("air", {0, 0, 0}, {3, 3, 3}), box("lamp", {1, 1, 1}, {2, 2, 2})}, {}});
  expect_areas(surface,
               {{"", 6}, {"xmin", 9}, {"xmax", 9}, {"ymin", 9}, {"ymax", 9}, {"zmin", 9}, {"zmax", 9}});
  EXPECT_EQ(surface.facets.size(), 12u);
  EXPECT_TRUE(surface.holes.empty());
}

TEST(BoxArrangement, BoxOnAWallOpensTheWall) {
  const SurfaceComplex surface =
      arrange({{box("air", {0, 0, 0}, {3, 3, 3}), box("lamp", {1, 1, 2}, {2, 2, 3})}, {}});
  expect_areas(surface,
               {{"", 5}, {"xmin", 9}, {"xmax", 9}, {"ymin", 9}, {"ymax", 9}, {"zmin", 9}, {"zmax", 9}});
  std::size_t opened = 0;
  for (const SurfaceFacet& facet : surface.facets) {
    opened += facet.openings.size();
    for (const Vec3& opening : facet.openings) EXPECT_EQ(opening, Vec3(1.5, 1.5, 3));
  }
  EXPECT_EQ(opened, 1u);
}

TEST(BoxArrangement, EqualBoxesLeaveTheLaterRegionOnly) {
  const SurfaceComplex surface =
      arrange({{box("old", {0, 0, 0}, {1, 1, 1}), box("new", {0, 0, 0}, {1, 1, 1})}, {}});
  EXPECT_EQ(surface.region_names, std::vector<std::string>{"new"});
  EXPECT_EQ(surface.facets.size(), 6u);
}

TEST(BoxArrangement, DisjointBoxesAreTwoDomains) {
  const SurfaceComplex surface =
      arrange({{box("a", {0, 0, 0}, {1, 1, 1}), box("a", {2, 0, 0}, {3, 1, 1})}, {}});
  expect_areas(surface, {{"xmin", 2}, {"xmax", 2}, {"ymin", 2}, {"ymax", 2}, {"zmin", 2}, {"zmax", 2}});
  EXPECT_EQ(seed_counts(surface), (Counts{{"a", 2}}));
}

TEST(BoxArrangement, BoxesThatTouchInAnEdgeKeepTheirWalls) {
  const SurfaceComplex surface =
      arrange({{box("a", {0, 0, 0}, {1, 1, 1}), box("a", {1, 1, 0}, {2, 2, 1})}, {}});
  expect_areas(surface, {{"xmin", 2}, {"xmax", 2}, {"ymin", 2}, {"ymax", 2}, {"zmin", 2}, {"zmax", 2}});
  EXPECT_EQ(surface.facets.size(), 12u);
  EXPECT_EQ(surface.points.size(), 14u);
  EXPECT_EQ(seed_counts(surface), (Counts{{"a", 2}}));
}

TEST(BoxArrangement, BoxesThatTouchInAVertexShareIt) {
  const SurfaceComplex surface =
      arrange({{box("a", {0, 0, 0}, {1, 1, 1}), box("b", {1, 1, 1}, {2, 2, 2})}, {}});
  EXPECT_EQ(surface.points.size(), 15u);
  EXPECT_EQ(surface.facets.size(), 12u);
}

TEST(BoxArrangement, HoleLeavesWallsOfItsNameAndAHolePoint) {
  const SurfaceComplex surface =
      arrange({{box("air", {0, 0, 0}, {3, 3, 3}), box_hole("crate", {1, 1, 1}, {2, 2, 2})}, {}});
  expect_areas(surface, {{"xmin", 9},
                         {"xmax", 9},
                         {"ymin", 9},
                         {"ymax", 9},
                         {"zmin", 9},
                         {"zmax", 9},
                         {"crate.xmin", 1},
                         {"crate.xmax", 1},
                         {"crate.ymin", 1},
                         {"crate.ymax", 1},
                         {"crate.zmin", 1},
                         {"crate.zmax", 1}});
  ASSERT_EQ(surface.holes.size(), 1u);
  EXPECT_EQ(surface.holes.front(), Vec3(1.5, 1.5, 1.5));
  // crate.xmin is the side of the crate at its smallest x.
  for (const SurfaceFacet& facet : surface.facets) {
    if (surface.wall_names.at(static_cast<std::size_t>(facet.wall)) != "crate.xmin") continue;
    for (const std::vector<int>& segment : facet.polygons)
      for (const int point : segment) EXPECT_EQ(surface.points.at(static_cast<std::size_t>(point)).x(), 1);
  }
}

TEST(BoxArrangement, HoleOnTheFloorRemovesThatPartOfTheFloor) {
  const SurfaceComplex surface = arrange({{named(box("air", {0, 0, 0}, {3, 3, 3}), {{"zmin", "floor"}}),
                                           box_hole("crate", {1, 1, 0}, {2, 2, 1})},
                                          {}});
  expect_areas(surface, {{"xmin", 9},
                         {"xmax", 9},
                         {"ymin", 9},
                         {"ymax", 9},
                         {"floor", 8},
                         {"zmax", 9},
                         {"crate.xmin", 1},
                         {"crate.xmax", 1},
                         {"crate.ymin", 1},
                         {"crate.ymax", 1},
                         {"crate.zmax", 1}});
  EXPECT_TRUE(surface.holes.empty());  // open to the outside: the mesher removes it itself
}

TEST(BoxArrangement, VoidShutInByBoxesHasAHolePoint) {
  const SurfaceComplex surface = arrange(
      {{box("a", {0, 0, 0}, {3, 3, 1}), box("a", {0, 0, 2}, {3, 3, 3}), box("a", {0, 0, 1}, {1, 3, 2}),
        box("a", {2, 0, 1}, {3, 3, 2}), box("a", {1, 0, 1}, {2, 1, 2}), box("a", {1, 2, 1}, {2, 3, 2})},
       {}});
  ASSERT_EQ(surface.holes.size(), 1u);
  EXPECT_EQ(surface.holes.front(), Vec3(1.5, 1.5, 1.5));
  expect_areas(surface, {{"xmin", 10}, {"xmax", 10}, {"ymin", 10}, {"ymax", 10}, {"zmin", 10}, {"zmax", 10}});
}

TEST(BoxArrangement, RegionInsideAHoleIsADomainOfItsOwn) {
  const SurfaceComplex surface =
      arrange({{box("air", {0, 0, 0}, {5, 5, 5}), box_hole("crate", {1, 1, 1}, {4, 4, 4}),
                box("inside", {2, 2, 2}, {3, 3, 3})},
               {}});
  EXPECT_EQ(seed_counts(surface), (Counts{{"air", 1}, {"inside", 1}}));
  EXPECT_EQ(surface.holes.size(), 1u);
  EXPECT_NEAR(wall_areas(surface).at("crate.xmin"), 10, 1e-11);
}

TEST(BoxArrangement, LastBoxThatNamesASideCounts) {
  const BoxPrimitive room = named(box("air", {0, 0, 0}, {4, 1, 1}), {{"zmin", "floor"}, {"xmin", "door"}});
  const BoxPrimitive silent = box("air", {1, 0, 0}, {2, 1, 1});
  const BoxPrimitive mat = named(box("air", {2, 0, 0}, {3, 1, 1}), {{"zmin", "mat"}, {"xmin", "hidden"}});
  expect_areas(arrange({{room, silent, mat}, {}}),
               {{"door", 1}, {"xmax", 1}, {"ymin", 4}, {"ymax", 4}, {"floor", 3}, {"mat", 1}, {"zmax", 4}});
}

TEST(BoxArrangement, LaterOfHoleAndNamedSideNamesTheirCommonFacet) {
  const BoxPrimitive glass = named(box("air", {0, 0, 0}, {1, 1, 1}), {{"xmax", "glass"}});
  const BoxPrimitive stone = box_hole("stone", {1, 0, 0}, {2, 1, 1});
  EXPECT_TRUE(wall_areas(arrange({{glass, stone}, {}})).contains("stone.xmin"));
  EXPECT_TRUE(wall_areas(arrange({{stone, glass}, {}})).contains("glass"));
}

TEST(BoxArrangement, LastPatchCounts) {
  const Geometry geometry{{named(box("air", {0, 0, 0}, {4, 4, 4}), {{"zmax", "ceiling"}})},
                          {patch("lamp", {1, 1, 4}, {3, 3, 4}), patch("bulb", {2, 2, 4}, {5, 3, 4})}};
  expect_areas(arrange(geometry), {{"xmin", 16},
                                   {"xmax", 16},
                                   {"ymin", 16},
                                   {"ymax", 16},
                                   {"zmin", 16},
                                   {"ceiling", 11},
                                   {"lamp", 3},
                                   {"bulb", 2}});
}

TEST(BoxArrangement, PatchMayNameTheSurfaceOfAHole) {
  const Geometry geometry{{box("air", {0, 0, 0}, {3, 3, 3}), box_hole("crate", {1, 1, 1}, {2, 2, 2})},
                          {patch("screen", {1, 1, 1}, {1, 2, 1.5})}};
  const Areas areas = wall_areas(arrange(geometry));
  EXPECT_NEAR(areas.at("screen"), 0.5, 1e-13);
  EXPECT_NEAR(areas.at("crate.xmin"), 0.5, 1e-13);
}

TEST(BoxArrangement, FacetsAreNotCutWhereNothingEnds) {
  // The planes of the lamp must not leave lines on the walls of the room.
  const Geometry geometry{{box("air", {0, 0, 0}, {9, 9, 9}), box("lamp", {4, 4, 4}, {5, 5, 5})},
                          {patch("window", {0, 1, 1}, {0, 2, 2})}};
  const SurfaceComplex surface = arrange(geometry);
  EXPECT_EQ(surface.facets.size(), 13u);
  EXPECT_EQ(surface.points.size(), 20u);
}

TEST(BoxArrangement, RefusesABoxWithoutExtent) {
  EXPECT_EQ(
      fault_of({{box("air", {0, 0, 0}, {1, 1, 0})}, {}}),
      "case.toml:7: mesh.box = [0, 0, 0] to [1, 1, 0]: min must be below max (the box has no extent along "
      "z); swap or move the corners");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault_of({{box("air", {0, nan, 0}, {1, 1, 1})}, {}}),
            "case.toml:7: mesh.box = [0, nan, 0] to [1, 1, 1]: coordinates must be finite numbers");
}

TEST(BoxArrangement, RefusesUnknownSides) {
  EXPECT_EQ(
      fault_of({{named(box("air", {0, 0, 0}, {1, 1, 1}), {{"top", "roof"}})}, {}}),
      "case.toml:7: mesh.box = [0, 0, 0] to [1, 1, 1]: walls.top is not a side of a box; xmin, xmax, ymin, "
      "ymax, zmin or zmax");
}

TEST(BoxArrangement, RefusesNamelessPrimitives) {
  EXPECT_THAT(fault_of({{box("", {0, 0, 0}, {1, 1, 1})}, {}}), testing::HasSubstr("needs a `region`"));
  EXPECT_THAT(fault_of({{box_hole("", {0, 0, 0}, {1, 1, 1})}, {}}),
              testing::HasSubstr("a hole needs a `name`"));
}

TEST(BoxArrangement, RefusesAPatchThatIsNotARectangle) {
  const BoxPrimitive room = box("air", {0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(
      fault_of({{room}, {patch("lamp", {0, 0, 0}, {1, 1, 1})}}),
      "case.toml:30: mesh.patch = [0, 0, 0] to [1, 1, 1]: min and max must agree in exactly one coordinate "
      "(a patch is a rectangle on a wall; here they agree in 0)");
  EXPECT_THAT(fault_of({{room}, {patch("lamp", {0, 0, 0}, {1, 0, 0})}}), testing::HasSubstr("agree in 2"));
}

TEST(BoxArrangement, RefusesAPatchThatCoversNoBoundary) {
  const Geometry geometry{{box("air", {0, 0, 0}, {1, 1, 1}), box("gas", {1, 0, 0}, {2, 1, 1})},
                          {patch("lamp", {1, 0, 0}, {1, 1, 1})}};
  EXPECT_EQ(
      fault_of(geometry),
      "case.toml:30: mesh.patch = [1, 0, 0] to [1, 1, 1]: wall \"lamp\" covers no boundary (nothing of the "
      "patch lies on the outside, or later patches hide it); move it onto a wall");
}

TEST(BoxArrangement, RefusesPlanesThatNearlyCoincide) {
  const Geometry geometry{{box("a", {0, 0, 0}, {0.5, 1, 1}), box("b", {0.5 + 4e-9, 0, 0}, {1, 1, 1})}, {}};
  EXPECT_EQ(fault_of(geometry),
            "case.toml:7: mesh.box: x = 0.5 and x = 0.500000004 are nearly but not quite the same plane (the "
            "gap cannot be meshed); make them equal");
  Geometry snapping = geometry;
  snapping.snap = 1e-8;
  EXPECT_EQ(fault_of(snapping), "no fault");
  Geometry rounding{{box("a", {0, 0, 0}, {0.3, 1, 1}), box("b", {0.1 + 0.2, 0, 0}, {1, 1, 1})}, {}};
  EXPECT_EQ(fault_of(rounding), "no fault");
  rounding.snap = 0;
  EXPECT_EQ(
      fault_of(rounding),
      "case.toml:7: mesh.box: x = 0.3 and x = 0.30000000000000004 are nearly but not quite the same plane "
      "(the gap cannot be meshed); make them equal");
}

TEST(BoxArrangement, RefusesASceneWithoutRegion) {
  EXPECT_EQ(fault_of({}), "no primitive has a region (there is nothing to mesh); add a box with a region");
  EXPECT_THAT(fault_of({{box_hole("crate", {0, 0, 0}, {1, 1, 1})}, {}}),
              testing::HasSubstr("nothing to mesh"));
  EXPECT_EQ(fault_of({{box("air", {0, 0, 0}, {1, 1, 1}), box_hole("crate", {0, 0, 0}, {1, 1, 1})}, {}}),
            "case.toml:7: mesh.box: the holes leave no region (there is nothing to mesh)");
}

TEST(BoxArrangement, ReportsAllFaultsAtOnce) {
  try {
    arrange({{box("air", {0, 0, 0}, {0, 1, 1}), box("gas", {0, 0, 0}, {1, 1, -1})}, {}});
    FAIL() << "no fault";
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults().size(), 2u);
  }
}

}  // namespace
}  // namespace etendue::box_arrangement_test
