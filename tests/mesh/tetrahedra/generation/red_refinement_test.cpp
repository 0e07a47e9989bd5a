// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/generation/red_refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/tetrahedra/generation/tetrahedralize.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::red_refinement_test {
namespace {

RawMesh two_regions_raw() { return tetrahedralize(two_region_surface(), {{2e-2, 2e-2}, 1.4, {}}); }

std::map<std::string, double> areas_of(const TetrahedralMesh& mesh) {
  std::map<std::string, double> areas;
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f)
    areas[mesh.wall_names()[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))]] += mesh.area(FaceIndex(f));
  return areas;
}

std::map<std::string, double> volumes_of(const TetrahedralMesh& mesh) {
  std::map<std::string, double> volumes;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    volumes[mesh.region_names()[static_cast<std::size_t>(mesh.region(CellIndex(c)))]] +=
        mesh.volume(CellIndex(c));
  return volumes;
}

/// 1 for the regular tetrahedron, 0 for a flat one: 12 (3 V)^(2/3) / sum of squared edges.
double worst_shape(const TetrahedralMesh& mesh) {
  double worst = 1;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c) {
    const auto& v = mesh.vertices(CellIndex(c));
    double squares = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j)
        squares += (mesh.point(VertexIndex(v[i])) - mesh.point(VertexIndex(v[j]))).squaredNorm();
    worst = std::min(worst, 12 * std::pow(3 * mesh.volume(CellIndex(c)), 2.0 / 3) / squares);
  }
  return worst;
}

TEST(RedRefinement, CutsEveryCellIntoEightOfOneVolume) {
  const RawMesh coarse = single_tetrahedron_raw();
  const TetrahedralMesh fine(red_refinement(coarse));
  ASSERT_EQ(fine.cell_count(), 8);
  for (const double volume : fine.volumes()) EXPECT_NEAR(volume, 1.0 / 48, 1e-16);
}

TEST(RedRefinement, KeepsRegionsWallsAndWhatLiesBetweenCells) {
  const RawMesh raw = two_regions_raw();
  const TetrahedralMesh coarse(raw), fine(red_refinement(raw));
  EXPECT_EQ(fine.cell_count(), 8 * coarse.cell_count());
  // Cells that did not fit together would leave faces without a neighbour.
  EXPECT_EQ(fine.boundary_face_count(), 4 * coarse.boundary_face_count());
  const auto before = areas_of(coarse), after = areas_of(fine);
  ASSERT_EQ(before.size(), after.size());
  for (const auto& [wall, area] : before) EXPECT_NEAR(after.at(wall), area, 1e-13) << wall;
  for (const auto& [region, volume] : volumes_of(coarse))
    EXPECT_NEAR(volumes_of(fine).at(region), volume, 1e-13) << region;
}

TEST(RedRefinement, KeepsTheShapesBounded) {
  RawMesh raw = two_regions_raw();
  const double first = worst_shape(TetrahedralMesh(raw));
  for (int times = 0; times < 3; ++times) raw = red_refinement(raw);
  EXPECT_GT(worst_shape(TetrahedralMesh(raw)), 0.5 * first);
}

TEST(RedRefinement, KeepsThePointsOfTheCoarseMesh) {
  const RawMesh coarse = kuhn_cube_raw();
  const RawMesh fine = red_refinement(coarse);
  // 8 corners, 12 edges, 6 diagonals of sides and one of the cube.
  EXPECT_EQ(fine.points.size(), 8u + 12 + 6 + 1);
  for (std::size_t p = 0; p < coarse.points.size(); ++p) EXPECT_EQ(fine.points[p], coarse.points[p]);
}

}  // namespace
}  // namespace etendue::red_refinement_test
