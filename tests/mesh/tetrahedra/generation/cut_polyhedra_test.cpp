// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/generation/cut_polyhedra.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "base/errors.h"
#include "base/position.h"
#include "mesh/tetrahedra/generation/red_refinement.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "tests/mesh/polyhedra/sample_polyhedra.h"

namespace etendue::cut_polyhedra_test {
namespace {

using namespace sample_polyhedra;

RawMesh cut(PolyhedralMesh mesh) {
  return cut_polyhedra(std::make_shared<const PolyhedralMesh>(std::move(mesh)));
}

double volume_of(const TetrahedralMesh& mesh) {
  double sum = 0;
  for (const double volume : mesh.volumes()) sum += volume;
  return sum;
}

/// A box whose inner points are moved, so that faces are not flat.
PolyhedralMesh skewed(const std::array<int, 3>& cells) {
  PolyhedralMesh mesh = hexahedra(cells);
  for (Vec3& point : mesh.points) {
    const double inside = std::sin(std::numbers::pi * point.x()) * std::sin(std::numbers::pi * point.y()) *
                          std::sin(std::numbers::pi * point.z());
    point += 0.08 * inside * Vec3(std::sin(9 * point.y()), std::cos(7 * point.z()), std::sin(8 * point.x()));
  }
  return mesh;
}

std::string fault_of(PolyhedralMesh mesh) {
  mesh.file = "case";
  try {
    const TetrahedralMesh cut_mesh(cut(std::move(mesh)));
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(CutPolyhedra, KeepsTheVolumeOfEachKindOfCell) {
  const std::vector<std::pair<PolyhedralMesh, double>> kinds = {{hexahedra({1, 1, 1}), 1},
                                                                {prism(), 1.0 / 2},
                                                                {pyramid(), 1.0 / 3},
                                                                {tetrahedron(), 1.0 / 6},
                                                                {hexagonal_prism(), 1.5 * std::sqrt(3)},
                                                                {truncated_cube(), 47.0 / 48},
                                                                {cube_of_nine_faces(), 1}};
  for (const auto& [mesh, volume] : kinds)
    EXPECT_NEAR(volume_of(TetrahedralMesh(cut(mesh))), volume, 1e-14) << mesh.points.size();
}

TEST(CutPolyhedra, LeavesTetrahedraAsTheyAre) {
  const RawMesh raw = cut(tetrahedron());
  EXPECT_EQ(raw.cells.size(), 1U);
  EXPECT_EQ(raw.points.size(), 4U);
  EXPECT_EQ(raw.triangles.size(), 4U);
}

TEST(CutPolyhedra, MakesTwelvePartsOfAHexahedronAroundItsCentroid) {
  const RawMesh raw = cut(hexahedra({1, 1, 1}, Vec3(2, 4, 6)));
  EXPECT_EQ(raw.cells.size(), 12U);
  ASSERT_EQ(raw.points.size(), 9U);
  EXPECT_NEAR((raw.points[8] - Vec3(1, 2, 3)).norm(), 0, 1e-14);
}

TEST(CutPolyhedra, ConformsWhereFacesAreNotFlat) {
  const RawMesh raw = cut(skewed({3, 4, 5}));
  std::map<std::array<int, 3>, int> sides;
  for (const auto& cell : raw.cells)
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      std::array<int, 3> face{};
      for (std::size_t i = 0, at = 0; i < 4; ++i)
        if (i != left_out) face[at++] = cell[i];
      std::ranges::sort(face);
      ++sides[face];
    }
  std::size_t outside = 0;
  for (const auto& [face, count] : sides) {
    EXPECT_LE(count, 2);
    if (count == 1) ++outside;
  }
  EXPECT_EQ(outside, raw.triangles.size());
  EXPECT_EQ(outside, 2U * 2 * (12 + 15 + 20));
  EXPECT_NEAR(volume_of(TetrahedralMesh(raw)), 1, 1e-13);
}

TEST(CutPolyhedra, ClosesTheBoundaryWallByWall) {
  const TetrahedralMesh mesh(cut(skewed({2, 3, 4})));
  ASSERT_EQ(mesh.wall_names().size(), 6U);
  std::array<Vec3, 6> areas;
  areas.fill(Vec3::Zero());
  for (int f = 0; f < mesh.boundary_face_count(); ++f)
    areas[position(mesh.wall(FaceIndex(f)))] += mesh.area_normal(FaceIndex(f));
  for (std::size_t w = 0; w < 6; ++w) {
    Vec3 expected = Vec3::Zero();
    expected[static_cast<int>(w) / 2] = w % 2 == 0 ? -1 : 1;
    EXPECT_NEAR((areas[w] - expected).norm(), 0, 1e-13) << mesh.wall_names()[w];
  }
}

TEST(CutPolyhedra, TellsTheParentsOfCellsAndBoundaryFaces) {
  const PolyhedralMesh whole = hexahedra({2, 3, 4});
  const TetrahedralMesh mesh(red_refinement(cut(whole)));
  const ParentCells& parents = mesh.parents();
  ASSERT_EQ(parents.cells.size(), 24U * 12 * 8);
  ASSERT_EQ(parents.faces.size(), 52U * 2 * 4);
  for (int c = 0; c < mesh.cell_count(); ++c) {
    const Vec3 x = mesh.centroid(CellIndex(c));
    const int cell =
        static_cast<int>(2 * x.x()) + 2 * static_cast<int>(3 * x.y()) + 6 * static_cast<int>(4 * x.z());
    EXPECT_EQ(parents.cells[position(c)], cell);
  }
  std::vector<double> areas(whole.face_count(), 0);
  for (int f = 0; f < mesh.boundary_face_count(); ++f) {
    const auto parent = position(parents.faces[position(f)]);
    areas[parent] += mesh.area(FaceIndex(f));
    EXPECT_EQ(whole.wall_names[position(whole.face_walls[parent])],
              mesh.wall_names()[position(mesh.wall(FaceIndex(f)))]);
  }
  EXPECT_NEAR(areas.back(), 1.0 / 6, 1e-14);
}

TEST(CutPolyhedra, KeepsMeansOfAnAffineField) {
  const auto field = [](const Vec3& x) { return 3 + 2 * x.x() - 5 * x.y() + 7 * x.z(); };
  const TetrahedralMesh mesh(cut(hexahedra({3, 2, 4})));
  std::vector<double> sums(24, 0);
  for (int c = 0; c < mesh.cell_count(); ++c)
    sums[position(mesh.parents().cells[position(c)])] +=
        mesh.volume(CellIndex(c)) * field(mesh.centroid(CellIndex(c)));
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(24 * sums[position(i + 3 * (j + 2 * k))],
                    field(Vec3((i + 0.5) / 3, (j + 0.5) / 2, (k + 0.5) / 4)), 1e-13);
}

TEST(CutPolyhedra, RefusesWarpedCellsWithNumberAndPlace) {
  PolyhedralMesh mesh = hexahedra({2, 1, 1});
  mesh.points[0] = Vec3(0.45, 0.9, 0.9);  // beyond the center of its cell
  const std::string fault = fault_of(mesh);
  EXPECT_EQ(
      fault.find("case: cell 0 at (0.30625, 0.6125, 0.6125): the tetrahedron from its center to points "), 0U)
      << fault;
  EXPECT_NE(fault.find("which must be positive (the cell is warped, flat or not star-shaped)"),
            std::string::npos);
}

TEST(CutPolyhedra, RefusesFlatCellsAndPointsThatAreNotFinite) {
  EXPECT_NE(fault_of(hexahedra({1, 1, 1}, Vec3(1, 1, 0))).find("has the volume 0, which"), std::string::npos);
  PolyhedralMesh mesh = prism();
  mesh.points[3].x() = NAN;
  EXPECT_EQ(fault_of(mesh), "case: point 3: coordinates (nan, 0, 1) are not finite");
}

TEST(CutPolyhedra, RefusesCellsThatFacesDoNotEnclose) {
  PolyhedralMesh mesh = hexahedra({2, 1, 1});
  mesh.neighbors[0] = -1;  // the second cell loses a face
  EXPECT_EQ(
      fault_of(mesh).find("case: cell 1 at (0.75, 0.5, 0.5): its faces do not enclose it (edge from point "),
      0U)
      << fault_of(mesh);
  mesh = hexahedra({1, 1, 1});
  std::reverse(mesh.face_points.begin(), mesh.face_points.begin() + 4);
  EXPECT_NE(fault_of(mesh).find("its faces do not enclose it"), std::string::npos);
}

TEST(CutPolyhedra, MakesASheetOfABaffle) {
  PolyhedralMesh mesh = hexahedra({2, 1, 1});
  const std::vector<int> back(mesh.face_points.begin(), mesh.face_points.begin() + 4);
  mesh.neighbors[0] = -1;
  mesh.face_walls[0] = 6;
  mesh.wall_names.emplace_back("left side");
  mesh.face_points.insert(mesh.face_points.end(), back.rbegin(), back.rend());
  mesh.face_ends.push_back(static_cast<int>(mesh.face_points.size()));
  mesh.owners.push_back(1);
  mesh.neighbors.push_back(-1);
  mesh.face_walls.push_back(7);
  mesh.wall_names.emplace_back("right side");
  const TetrahedralMesh parts(cut(mesh));
  EXPECT_EQ(parts.boundary_face_count(), 2 * 12);
  EXPECT_EQ(parts.wall_names().size(), 8U);
}

}  // namespace
}  // namespace etendue::cut_polyhedra_test
