// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geometry/arrangement/snapping.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mesh/geometry/arrangement/arrangement.h"
#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "tests/mesh/geometry/mesh_measures.h"
#include "tests/mesh/geometry/scene.h"

namespace etendue::snapping_test {
namespace {

std::map<std::string, double> volumes(const Geometry& geometry) {
  return region_volumes(TetrahedralMesh(tetrahedralize(arrange(geometry), {})));
}

TEST(Snapping, MakesCoordinatesWithinTheDistanceEqualToTheFirstInTheFile) {
  std::vector<std::string> lines;
  const Geometry geometry =
      snapped({{box("a", {0, 0, 0}, {0.3, 1, 1}), box("b", {0.1 + 0.2, 0, 0}, {1, 1, 1})}, {}},
              [&](std::string_view line) { lines.emplace_back(line); });
  EXPECT_EQ(std::get<BoxPrimitive>(geometry.primitives.at(1)).min.x(), 0.3);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines.front(),
            "mesh.snap = 1e-09: coordinates moved: 1, by at most 5.6e-17; the first: x = 0.30000000000000004 "
            "becomes "
            "0.3 (mesh.box, line 7)");
}

TEST(Snapping, LeavesAndTellsNothingWhereCoordinatesDiffer) {
  const Geometry geometry{{box("a", {0, 0, 0}, {1, 1, 1}), sphere("b", {0.5, 0.5 + 1e-8, 0.5}, 0.3, 80)}, {}};
  const Geometry same = snapped(geometry, [](std::string_view line) { ADD_FAILURE() << line; });
  EXPECT_EQ(std::get<SpherePrimitive>(same.primitives.at(1)).center, Vec3(0.5, 0.5 + 1e-8, 0.5));
}

TEST(Snapping, RefusesBodiesThatVanish) {
  EXPECT_EQ(
      fault_of({{box("a", {0, 0, 0}, {4, 1, 1}), box("b", {1, 0, 0}, {1 + 1e-9, 1, 1})}, {}}),
      "case.toml:7: mesh.box: is thinner than 4e-09, within which mesh.snap makes coordinates equal; make "
      "it thicker, or mesh.snap smaller");
}

TEST(Snapping, BodiesThatNearlyCoincideAreMeshed) {
  for (const double gap : {1e-9, 1e-10, 1e-11, 1e-12}) {
    const auto boxes = volumes({{box("a", {0, 0, 0}, {4, 3, 2}), box("b", {1, 1, gap}, {2, 2 + gap, 1}),
                                 box("c", {2 - gap, 1 + gap, 0}, {3, 2, 1 + gap})},
                                {}});
    EXPECT_NEAR(boxes.at("a"), 22, 1e-7) << gap;
    const auto balls = volumes({{box("a", {0, 0, 0}, {3, 3, 2}), sphere("b", {1.5, 1.5, 1 - gap}, 1, 80),
                                 sphere("c", {1.5, 1.5 + gap, 1}, 1 + gap, 80)},
                                {}});
    EXPECT_EQ(balls.size(), 2u) << gap;
    const auto pipes = volumes(
        {{box("a", {0, 0, 0}, {4, 4, 2}), cylinder("b", {2, gap, 1}, {2, 4 - gap, 1}, 1 - gap, 8)}, {}});
    EXPECT_NEAR(pipes.at("b"), 8 * std::sqrt(2), 1e-7) << gap;
  }
}

}  // namespace
}  // namespace etendue::snapping_test
