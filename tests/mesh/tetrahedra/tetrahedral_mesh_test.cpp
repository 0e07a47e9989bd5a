// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/tetrahedral_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>
#include <set>

#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::tetrahedral_mesh_test {
namespace {

TEST(TetrahedralMesh, MeasuresTheUnitCube) {
  const TetrahedralMesh mesh(kuhn_cube_raw());
  EXPECT_EQ(mesh.cell_count(), 6);
  EXPECT_EQ(mesh.vertex_count(), 8);
  EXPECT_EQ(mesh.boundary_face_count(), 12);
  EXPECT_EQ(mesh.face_count(), 18);
  double volume = 0;
  for (const double v : mesh.volumes()) volume += v;
  EXPECT_NEAR(volume, 1, 1e-12);
  std::array<Vec3, 6> area;
  area.fill(Vec3::Zero());
  for (int f = 0; f < mesh.boundary_face_count(); ++f)
    area[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))] += mesh.area_normal(FaceIndex(f));
  for (int side = 0; side < 6; ++side) {
    const Vec3 outward = (side % 2 ? 1 : -1) * Vec3::Unit(side / 2);
    EXPECT_LT((area[static_cast<std::size_t>(side)] - outward).norm(), 1e-12);
  }
}

TEST(TetrahedralMesh, NormalsOfEachCellPointOutAndSumToZero) {
  const TetrahedralMesh mesh = cube_mesh(1e-3);
  for (int c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      const FaceIndex face(mesh.faces(cell)[i]);
      const Vec3 out = mesh.owner(face) == cell ? mesh.area_normal(face) : Vec3(-mesh.area_normal(face));
      const Vec3& opposite = mesh.point(VertexIndex(mesh.vertices(cell)[i]));
      // The height over face i times its area is three volumes.
      EXPECT_NEAR(out.dot(mesh.centroid(face) - opposite) / 3, mesh.volume(cell), 1e-15);
      sum += out;
    }
    EXPECT_LT(sum.norm(), 1e-16);
  }
}

TEST(TetrahedralMesh, VerticesRiseAndFacesLieOppositeTheirVertex) {
  const TetrahedralMesh mesh = two_region_mesh(1e-3);
  for (int c = 0; c < mesh.cell_count(); ++c) {
    const auto& v = mesh.vertices(CellIndex(c));
    EXPECT_TRUE(std::is_sorted(v.begin(), v.end()));
    for (std::size_t i = 0; i < 4; ++i) {
      std::vector<std::int32_t> others(v.begin(), v.end());
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      const auto& f = mesh.vertices(FaceIndex(mesh.faces(CellIndex(c))[i]));
      EXPECT_TRUE(std::equal(others.begin(), others.end(), f.begin(), f.end()));
    }
  }
}

TEST(TetrahedralMesh, NumbersBoundaryFacesFirst) {
  const TetrahedralMesh mesh = cube_mesh(1e-3);
  for (int f = 0; f < mesh.face_count(); ++f) {
    EXPECT_EQ(mesh.face_cells()[static_cast<std::size_t>(f)][1] < 0, f < mesh.boundary_face_count());
    if (f < mesh.boundary_face_count()) continue;
    EXPECT_LT(mesh.owner(FaceIndex(f)), mesh.neighbour(FaceIndex(f)));
  }
}

/// The raw mesh that a mesh would be written as.
RawMesh raw_of(const TetrahedralMesh& mesh) {
  RawMesh raw;
  raw.points.assign(mesh.points().begin(), mesh.points().end());
  raw.cells.assign(mesh.cell_vertices().begin(), mesh.cell_vertices().end());
  raw.cell_regions.assign(mesh.cell_regions().begin(), mesh.cell_regions().end());
  raw.triangles.assign(mesh.face_vertices().begin(),
                       mesh.face_vertices().begin() + mesh.boundary_face_count());
  raw.triangle_walls.assign(mesh.face_walls().begin(), mesh.face_walls().end());
  raw.region_names = mesh.region_names();
  raw.wall_names = mesh.wall_names();
  // Vertices that rise are not always positively oriented; a file needs that.
  for (std::size_t c = 0; c < raw.cells.size(); ++c) {
    auto& v = raw.cells[c];
    const auto point = [&](std::size_t i) { return raw.points[static_cast<std::size_t>(v[i])]; };
    if ((point(1) - point(0)).cross(point(2) - point(0)).dot(point(3) - point(0)) < 0) std::swap(v[2], v[3]);
  }
  return raw;
}

TEST(TetrahedralMesh, NumberingAgainChangesNothing) {
  const TetrahedralMesh mesh = two_region_mesh(1e-3);
  const TetrahedralMesh again(raw_of(mesh));
  EXPECT_TRUE(std::ranges::equal(mesh.points(), again.points()));
  EXPECT_TRUE(std::ranges::equal(mesh.cell_vertices(), again.cell_vertices()));
  EXPECT_TRUE(std::ranges::equal(mesh.cell_faces(), again.cell_faces()));
  EXPECT_TRUE(std::ranges::equal(mesh.face_cells(), again.face_cells()));
  EXPECT_TRUE(std::ranges::equal(mesh.face_area_normals(), again.face_area_normals()));
  EXPECT_TRUE(std::ranges::equal(mesh.volumes(), again.volumes()));
  EXPECT_TRUE(std::ranges::equal(mesh.cell_regions(), again.cell_regions()));
  EXPECT_TRUE(std::ranges::equal(mesh.face_walls(), again.face_walls()));
  EXPECT_EQ(mesh.region_names(), again.region_names());
  EXPECT_EQ(mesh.wall_names(), again.wall_names());
}

TEST(TetrahedralMesh, NumbersNeighboursNearEachOther) {
  const TetrahedralMesh mesh = cube_mesh(2.25e-4);
  double distance = 0;
  for (int f = mesh.boundary_face_count(); f < mesh.face_count(); ++f)
    distance += mesh.neighbour(FaceIndex(f)).value() - mesh.owner(FaceIndex(f)).value();
  distance /= mesh.face_count() - mesh.boundary_face_count();
  // Numbers at random would be a third of all cells apart.
  EXPECT_LT(distance, 0.1 * mesh.cell_count());
}

TEST(TetrahedralMesh, TakesCellsThatAreAllInsideOutAsAConvention) {
  RawMesh raw = kuhn_cube_raw();
  for (auto& cell : raw.cells) std::swap(cell[0], cell[1]);
  const TetrahedralMesh mesh(raw);
  for (const double volume : mesh.volumes()) EXPECT_NEAR(volume, 1.0 / 6, 1e-15);
}

TEST(TetrahedralMesh, LeavesUnusedPointsAndNamesOut) {
  RawMesh raw = kuhn_cube_raw();
  raw.points.emplace_back(9, 9, 9);
  raw.region_names = {"unused", "used"};
  raw.cell_regions.assign(6, 1);
  raw.wall_names.emplace_back("no face has it");
  const TetrahedralMesh mesh(raw);
  EXPECT_EQ(mesh.vertex_count(), 8);
  EXPECT_EQ(mesh.region_names(), std::vector<std::string>{"used"});
  EXPECT_EQ(mesh.wall_names().size(), 6u);
}

TEST(TetrahedralMesh, CallsTheWholeBoundaryBoundaryWhereNothingIsNamed) {
  const TetrahedralMesh mesh = single_tetrahedron();
  EXPECT_EQ(mesh.wall_names(), std::vector<std::string>{"boundary"});
  EXPECT_EQ(mesh.boundary_face_count(), 4);
  EXPECT_NEAR(mesh.volume(CellIndex(0)), 1.0 / 6, 1e-16);
  EXPECT_LT((mesh.centroid(CellIndex(0)) - Vec3::Constant(0.25)).norm(), 1e-16);
}

TEST(TetrahedralMesh, IgnoresNamedInterfaces) {
  RawMesh raw = kuhn_cube_raw();
  raw.wall_names.emplace_back("interface");
  raw.triangles.push_back({0, 7, 1});
  raw.triangle_walls.push_back(6);
  EXPECT_EQ(TetrahedralMesh(raw).wall_names().size(), 6u);
}

TEST(TetrahedralMesh, JoinsWallsOfTheSameName) {
  RawMesh raw = kuhn_cube_raw();
  raw.wall_names = {"side", "side", "side", "side", "floor", "ceiling"};
  const TetrahedralMesh mesh(raw);
  EXPECT_EQ(mesh.wall_names(), (std::vector<std::string>{"side", "floor", "ceiling"}));
}

/// True where the cells that light along `direction` passes through, from owner to neighbour or back, form
/// a circle: taking away cells without upwind cells does not take all.
bool has_cycle(const TetrahedralMesh& mesh, const Vec3& direction) {
  std::vector<int> upwind(static_cast<std::size_t>(mesh.cell_count()), 0);
  std::vector<std::vector<int>> downwind(upwind.size());
  for (int f = mesh.boundary_face_count(); f < mesh.face_count(); ++f) {
    int from = mesh.owner(FaceIndex(f)).value();
    int to = mesh.neighbour(FaceIndex(f)).value();
    if (mesh.area_normal(FaceIndex(f)).dot(direction) < 0) std::swap(from, to);
    downwind[static_cast<std::size_t>(from)].push_back(to);
    ++upwind[static_cast<std::size_t>(to)];
  }
  std::vector<int> ready;
  for (std::size_t c = 0; c < upwind.size(); ++c)
    if (upwind[c] == 0) ready.push_back(static_cast<int>(c));
  for (std::size_t i = 0; i < ready.size(); ++i)
    for (const int next : downwind[static_cast<std::size_t>(ready[i])])
      if (--upwind[static_cast<std::size_t>(next)] == 0) ready.push_back(next);
  return ready.size() < upwind.size();
}

TEST(SampleMeshes, RingIsCyclicAlongItsAxisAndTheCubeIsNot) {
  EXPECT_TRUE(has_cycle(cyclic_ring(), Vec3::UnitZ()));
  EXPECT_FALSE(has_cycle(cyclic_ring(), Vec3::UnitX()));
  EXPECT_FALSE(has_cycle(cube_mesh(1e-3), Vec3(0.3, 0.5, 0.8).normalized()));
}

}  // namespace
}  // namespace etendue::tetrahedral_mesh_test
