// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/search/cell_locator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::cell_locator_test {
namespace {

Vec3 point_at(const TetrahedralMesh& mesh, const CellPoint& place) {
  Vec3 point = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i)
    point += place.barycentric[i] * mesh.point(VertexIndex(mesh.vertices(place.cell)[i]));
  return point;
}

TEST(CellLocator, FindsTheOneCellOfEachCentroid) {
  const TetrahedralMesh mesh = two_region_mesh(1e-3);
  const CellLocator locator(mesh);
  for (int c = 0; c < mesh.cell_count(); ++c) {
    const auto found = locator.find(mesh.centroid(CellIndex(c)));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].cell, CellIndex(c));
    for (const double weight : found[0].barycentric) EXPECT_NEAR(weight, 0.25, 1e-11);
  }
}

TEST(CellLocator, GivesAllCellsOfFacesAndVertices) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const CellLocator locator(mesh);
  for (int f = 0; f < mesh.face_count(); ++f)
    EXPECT_EQ(locator.find(mesh.centroid(FaceIndex(f))).size(), f < mesh.boundary_face_count() ? 1u : 2u);
  std::vector<std::size_t> cells_of_vertex(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (const auto& cell : mesh.cell_vertices())
    for (const auto vertex : cell) ++cells_of_vertex[static_cast<std::size_t>(vertex)];
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const auto found = locator.find(mesh.point(VertexIndex(v)));
    EXPECT_EQ(found.size(), cells_of_vertex[static_cast<std::size_t>(v)]);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end(),
                               [](const CellPoint& a, const CellPoint& b) { return a.cell < b.cell; }));
  }
}

TEST(CellLocator, BarycentricCoordinatesGiveThePointBack) {
  const TetrahedralMesh mesh = cube_mesh(8, 20);
  const CellLocator locator(mesh);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(0, 20);
  for (int i = 0; i < 200; ++i) {
    const Vec3 point(anywhere(random), anywhere(random), anywhere(random));
    const auto found = locator.find(point);
    ASSERT_FALSE(found.empty());
    for (const CellPoint& place : found) EXPECT_LT((point_at(mesh, place) - point).norm(), 1e-11);
  }
}

TEST(CellLocator, ReachesAsFarAsTheTolerance) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const CellLocator locator(mesh);
  EXPECT_FALSE(locator.find({1 + 1e-9, 0.3, 0.4}).empty());
  EXPECT_FALSE(locator.find({-1e-9, -1e-9, 1 + 1e-9}).empty());
  EXPECT_TRUE(locator.find({1 + 1e-8, 0.3, 0.4}).empty());
  EXPECT_TRUE(locator.find({1e9, 0, 0}).empty());
  EXPECT_TRUE(locator.find(Vec3::Constant(std::nan(""))).empty());
}

TEST(CellLocator, SeesTheHoleInTheMiddleOfTheRing) {
  const TetrahedralMesh mesh = cyclic_ring();
  const CellLocator locator(mesh);
  EXPECT_TRUE(locator.find({0, 0, 0.25}).empty());
  EXPECT_FALSE(locator.find(mesh.centroid(CellIndex(7))).empty());
}

}  // namespace
}  // namespace etendue::cell_locator_test
