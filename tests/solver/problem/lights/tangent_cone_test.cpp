// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/problem/lights/tangent_cone.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/solver/problem/cube_mesh.h"

namespace etendue::tangent_cone_test {
namespace {

using std::numbers::pi;

TangentCone cone_at(const TetrahedralMesh& mesh, const Vec3& point) {
  return TangentCone(mesh, CellLocator(mesh).find(point));
}

TEST(TangentCone, IsTheWholeSphereInside) {
  const TetrahedralMesh mesh = cube_mesh();
  // In a cell, on a face between two cells, on the diagonal that all six share.
  for (const Vec3& point : {Vec3(0.2, 0.3, 0.6), Vec3(0.3, 0.3, 0.6), Vec3(0.5, 0.5, 0.5)}) {
    EXPECT_TRUE(cone_at(mesh, point).is_whole());
    EXPECT_EQ(cone_at(mesh, point).solid_angle(), 4 * pi);
    EXPECT_TRUE(cone_at(mesh, point).contains(-Vec3::UnitX()));
  }
}

TEST(TangentCone, HasTheSolidAngleOfTheDomainOnItsSurface) {
  const TetrahedralMesh mesh = cube_mesh();
  // On a wall, on a side that two triangles of it share, in an edge, in both kinds of corner.
  EXPECT_NEAR(cone_at(mesh, {0.2, 0.3, 1}).solid_angle(), 2 * pi, 1e-12);
  EXPECT_NEAR(cone_at(mesh, {0.5, 0.5, 1}).solid_angle(), 2 * pi, 1e-12);
  EXPECT_NEAR(cone_at(mesh, {0, 0.3, 1}).solid_angle(), pi, 1e-12);
  EXPECT_NEAR(cone_at(mesh, {0, 0, 0}).solid_angle(), pi / 2, 1e-12);
  EXPECT_NEAR(cone_at(mesh, {1, 0, 1}).solid_angle(), pi / 2, 1e-12);
}

TEST(TangentCone, ContainsWhatLeadsIntoTheDomain) {
  const TetrahedralMesh mesh = cube_mesh();
  const TangentCone on_wall = cone_at(mesh, {0.5, 0.5, 1}), in_edge = cone_at(mesh, {0, 0.3, 1});
  EXPECT_TRUE(on_wall.contains(Vec3(1, 2, -0.1)));
  EXPECT_FALSE(on_wall.contains(Vec3(1, 2, 0.1)));
  EXPECT_TRUE(in_edge.contains(Vec3(0.1, 2, -0.1)));
  EXPECT_FALSE(in_edge.contains(Vec3(-0.1, 2, -0.1)));
  EXPECT_FALSE(in_edge.contains(Vec3(0.1, 2, 0.1)));
}

}  // namespace
}  // namespace etendue::tangent_cone_test
