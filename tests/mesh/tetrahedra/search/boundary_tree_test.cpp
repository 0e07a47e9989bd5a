// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/search/boundary_tree.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::boundary_tree_test {
namespace {

std::string wall_at(const TetrahedralMesh& mesh, const BoundaryEntry& entry) {
  return mesh.wall_names()[static_cast<std::size_t>(mesh.wall(entry.face))];
}

TEST(BoundaryTree, FindsWhereARayComesIn) {
  const TetrahedralMesh mesh = cube_mesh(0.01);
  const BoundaryTree tree(mesh);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0.01, 0.99);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 target(0, any(random), any(random)), origin(-any(random), 3 * any(random) - 1, any(random));
    const auto entry = tree.first_entry(origin, (target - origin).normalized());
    ASSERT_TRUE(entry);
    // From there the sides y = 0 and y = 1 may turn their backs too, and then one of them is met first.
    if (wall_at(mesh, *entry) != "xmin") continue;
    EXPECT_LT((entry->point - target).norm(), 1e-12);
  }
}

TEST(BoundaryTree, FindsSidesAlongTheRay) {
  const TetrahedralMesh mesh = cube_mesh(0.01);
  const BoundaryTree tree(mesh);
  for (const double x : {0.0, 0.5, 1.0})
    for (const double y : {0.0, 0.5, 1.0}) {
      const auto entry = tree.first_entry({x, y, 2}, -Vec3::UnitZ());
      ASSERT_TRUE(entry) << x << ' ' << y;
      EXPECT_EQ(wall_at(mesh, *entry), "zmax");
    }
}

TEST(BoundaryTree, SeesNoFaceFromInside) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  const BoundaryTree tree(mesh);
  EXPECT_FALSE(tree.first_entry({0.5, 0.5, 0.5}, Vec3::UnitX()));
  EXPECT_FALSE(tree.first_entry({-1, 0.5, 0.5}, -Vec3::UnitX()));
  EXPECT_FALSE(tree.first_entry({-1, 1.5, 0.5}, Vec3::UnitX()));
}

TEST(BoundaryTree, LetsNoRayThroughBetweenFaces) {
  const TetrahedralMesh mesh(kuhn_cube_raw());
  const BoundaryTree tree(mesh);
  // Along the diagonal that cuts the side x = 0 in two.
  for (int i = 1; i < 100; ++i) {
    const double t = i / 100.0;
    EXPECT_TRUE(tree.first_entry({-1, t, t}, Vec3::UnitX())) << t;
    EXPECT_TRUE(tree.first_entry({-1, t, 1 - t}, Vec3::UnitX())) << t;
  }
}

}  // namespace
}  // namespace etendue::boundary_tree_test
