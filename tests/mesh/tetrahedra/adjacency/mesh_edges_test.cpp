// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/adjacency/mesh_edges.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::mesh_edges_test {
namespace {

// Of a ball of tetrahedra, V - E + F - C = 1 (Euler and Poincare).
TEST(MeshEdges, AreAsManyAsEulerSays) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  const MeshEdges edges(mesh, [](std::int32_t) { return true; });
  EXPECT_EQ(
      mesh.vertex_count() - static_cast<std::int64_t>(edges.size()) + mesh.face_count() - mesh.cell_count(),
      1);
}

TEST(MeshEdges, AreFoundByTheirEndsInAnyOrderAndBelongToACellThatHasThem) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  const MeshEdges edges(mesh, [](std::int32_t) { return true; });
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto& [first, second, cell] = edges[e];
    EXPECT_LT(first, second);
    EXPECT_EQ(edges.between(first, second), e);
    EXPECT_EQ(edges.between(second, first), e);
    for (const std::int32_t v : {first, second}) EXPECT_EQ(std::ranges::count(mesh.vertices(cell), v), 1);
  }
}

TEST(MeshEdges, JoinOnlyVerticesThatAreWanted) {
  const TetrahedralMesh mesh = cube_mesh(5e-3);
  const auto even = [](std::int32_t v) { return v % 2 == 0; };
  const MeshEdges edges(mesh, even);
  EXPECT_GT(edges.size(), 0u);
  for (std::size_t e = 0; e < edges.size(); ++e) EXPECT_TRUE(even(edges[e].first) && even(edges[e].second));
}

}  // namespace
}  // namespace etendue::mesh_edges_test
