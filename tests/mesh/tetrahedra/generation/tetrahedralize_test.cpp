// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/tetrahedra/generation/tetrahedralize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>

#include "mesh/tetrahedra/generation/narrow_gaps.h"
#include "mesh/tetrahedra/tetrahedral_mesh.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::tetrahedralize_test {
namespace {

std::string message_of(const SurfaceComplex& surface, const TetrahedraOptions& options = {}) {
  try {
    tetrahedralize(surface, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

double region_volume(const TetrahedralMesh& mesh, const std::string& name) {
  double volume = 0;
  for (int c = 0; c < mesh.cell_count(); ++c)
    if (mesh.region_names()[static_cast<std::size_t>(mesh.region(CellIndex(c)))] == name)
      volume += mesh.volume(CellIndex(c));
  return volume;
}

TEST(Tetrahedralize, FillsTheCubeExactly) {
  const TetrahedralMesh mesh = cube_mesh(2.25e-4);
  EXPECT_NEAR(mesh.cell_count(), 11900, 600);
  EXPECT_NEAR(region_volume(mesh, "domain"), 1, 1e-12);
  // TetGen's closing optimisation exceeds the bound a little.
  EXPECT_LE(*std::max_element(mesh.volumes().begin(), mesh.volumes().end()), 1.3 * 2.25e-4);
  std::vector<double> areas(mesh.wall_names().size(), 0);
  for (int f = 0; f < mesh.boundary_face_count(); ++f)
    areas[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))] += mesh.area(FaceIndex(f));
  ASSERT_EQ(mesh.wall_names(), (std::vector<std::string>{"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"}));
  for (const double area : areas) EXPECT_NEAR(area, 1, 1e-12);
}

TEST(Tetrahedralize, KeepsTheVolumesOfTwoRegions) {
  const TetrahedralMesh mesh = two_region_mesh(1e-3);
  EXPECT_EQ(mesh.region_names(), (std::vector<std::string>{"domain", "inner"}));
  EXPECT_NEAR(region_volume(mesh, "inner"), 0.125, 1e-12);
  EXPECT_NEAR(region_volume(mesh, "domain"), 0.875, 1e-12);
}

TEST(Tetrahedralize, BoundsTheCellsOfEachRegion) {
  TetrahedraOptions options;
  options.max_volume = {0, 1e-4};
  const TetrahedralMesh mesh(tetrahedralize(two_region_surface(), options));
  std::array<double, 2> largest = {0, 0};
  for (int c = 0; c < mesh.cell_count(); ++c) {
    double& volume = largest[static_cast<std::size_t>(mesh.region(CellIndex(c)))];
    volume = std::max(volume, mesh.volume(CellIndex(c)));
  }
  EXPECT_LT(largest[1], 2e-4);
  EXPECT_GT(largest[0], 5e-4);
}

TEST(Tetrahedralize, LeavesHolesEmpty) {
  SurfaceComplex surface = two_region_surface();
  surface.seeds.pop_back();
  surface.region_names.pop_back();
  surface.holes.push_back(Vec3::Constant(0.5));
  surface.wall_names.push_back("crate");
  for (std::size_t f = 6; f < 12; ++f) surface.facets[f].wall = 6;
  const TetrahedralMesh mesh(tetrahedralize(surface, {}));
  EXPECT_NEAR(region_volume(mesh, "domain"), 0.875, 1e-12);
  double area = 0;
  for (int f = 0; f < mesh.boundary_face_count(); ++f)
    if (mesh.wall_names()[static_cast<std::size_t>(mesh.wall(FaceIndex(f)))] == "crate")
      area += mesh.area(FaceIndex(f));
  EXPECT_NEAR(area, 1.5, 1e-12);
}

TEST(Tetrahedralize, CutsOpeningsOutOfFacets) {
  // The top of the cube with a window in it: a second facet with a wall of its own.
  SurfaceComplex surface = cube_surface();
  const int first = static_cast<int>(surface.points.size());
  for (const auto& [x, y] : {std::pair{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}})
    surface.points.emplace_back(x, y, 1);
  const std::vector<int> outline = {first, first + 1, first + 2, first + 3};
  surface.facets[5].polygons.push_back(outline);
  surface.facets[5].openings.emplace_back(0.5, 0.5, 1);
  surface.wall_names.push_back("window");
  surface.facets.push_back({{outline}, {}, 6});
  TetrahedraOptions options;
  options.max_volume = {1e-2};
  const TetrahedralMesh mesh(tetrahedralize(surface, options));
  double area = 0;
  for (int f = 0; f < mesh.boundary_face_count(); ++f)
    if (mesh.wall(FaceIndex(f)) == 6) area += mesh.area(FaceIndex(f));
  EXPECT_NEAR(area, 0.25, 1e-12);
}

TEST(Tetrahedralize, GivesTheSameMeshAgain) {
  TetrahedraOptions options;
  options.max_volume = {1e-3};
  const RawMesh first = tetrahedralize(cube_surface(), options);
  const RawMesh second = tetrahedralize(cube_surface(), options);
  EXPECT_EQ(first.cells, second.cells);
  EXPECT_EQ(first.points, second.points);
}

TEST(Tetrahedralize, RefusesMoreCellsThanTheMemoryHolds) {
  TetrahedraOptions options;
  options.origin = {"room.toml", 7, "mesh"};
  options.max_volume = {1e-16};
  const std::string message = message_of(cube_surface(), options);
  EXPECT_EQ(
      message.find("room.toml:7: mesh: max_volume or edge_length asks for about 2.5e+16 cells, for which "
                   "TetGen needs about 9.31e+09 GiB of memory, and this machine has "),
      0u)
      << message;
}

TEST(Tetrahedralize, EstimatesCellsByTheVolumesOfRegions) {
  TetrahedraOptions options;
  options.max_volume = {0, 1e-6};  // the inner cube alone: an eighth of the whole
  options.max_cells = 300'000;
  const std::string message = message_of(two_region_surface(), options);
  EXPECT_NE(message.find("asks for about 3.1e+05 cells, and max_cells allows 300000"), std::string::npos)
      << message;
}

TEST(Tetrahedralize, RefusesDetailsThatNeedMoreCellsThanAllowedWithTheirPlace) {
  SurfaceComplex surface = two_region_surface();
  const double thick = 1e-6;  // a needle in place of the inner cube
  for (std::size_t p = 8; p < 16; ++p)
    for (const int axis : {0, 1}) surface.points[p][axis] = surface.points[p][axis] < 0.5 ? 0.5 : 0.5 + thick;
  for (RegionSeed& seed : surface.seeds)
    if (seed.region == 1) seed.point = Vec3(0.5 + thick / 2, 0.5 + thick / 2, 0.5);
  TetrahedraOptions options;
  options.origin = {"room.toml", 7, "mesh"};
  options.max_cells = 20'000;
  const std::string message = message_of(surface, options);
  EXPECT_EQ(message.find("room.toml:7: mesh: the geometry has details so fine that it needs more than "
                         "20000 cells (edges near (0.5"),
            0u)
      << message;
}

TEST(CheckGaps, RefusesAGapThatTetGenTakesForNoneWithItsPlace) {
  SurfaceComplex surface = two_region_surface();
  const Origin origin{"room.toml", 7, "mesh"};
  check_gaps(surface, origin);
  for (std::size_t p = 8; p < 16; ++p)
    if (surface.points[p].x() < 0.5) surface.points[p].x() = 1e-10;
  try {
    check_gaps(surface, origin);
    ADD_FAILURE() << "is not refused";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find("room.toml:7: mesh: a corner at (1e-10, "), 0u) << message;
    EXPECT_NE(message.find("(the gap of 1e-10 cannot be meshed)"), std::string::npos) << message;
  }
}

// As in .poly files: a point of a slant facet that does not list it, with so many digits as were written.
TEST(Tetrahedralize, MeshesAPointBesideAFacetThatDoesNotListIt) {
  SurfaceComplex surface;
  surface.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.3333333333, 0.3333333333, 0.3333333333}};
  for (const std::vector<int>& corners :
       std::vector<std::vector<int>>{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}})
    surface.facets.push_back({.polygons = {corners}, .openings = {}, .wall = 0});
  surface.region_names = {"air"};
  surface.wall_names = {"wall"};
  surface.seeds = {{.point = {0.1, 0.1, 0.1}, .region = 0}};
  TetrahedraOptions options;
  options.max_volume = {0.01};
  const TetrahedralMesh mesh(tetrahedralize(surface, options));
  EXPECT_NEAR(std::accumulate(mesh.volumes().begin(), mesh.volumes().end(), 0.0), 1.0 / 6, 1e-9);
}

TEST(Tetrahedralize, AllowsAsManyCellsAsMaxCellsAndNoMore) {
  TetrahedraOptions options;
  options.max_volume = {0.01, 1e-4};  // small cells in an eighth of the whole
  const std::int32_t cells = TetrahedralMesh(tetrahedralize(two_region_surface(), options)).cell_count();
  ASSERT_GT(cells, 1000);
  options.max_cells = cells;
  EXPECT_EQ(TetrahedralMesh(tetrahedralize(two_region_surface(), options)).cell_count(), cells);
  options.max_cells = cells - 1;
  EXPECT_NE(
      message_of(two_region_surface(), options).find("more than " + std::to_string(cells - 1) + " cells"),
      std::string::npos);
}

TEST(Tetrahedralize, SendsChatterToTheLogAndNotToStandardOutput) {
  std::vector<std::string> lines;
  testing::internal::CaptureStdout();
  tetrahedralize(cube_surface(), {}, [&](std::string_view line) { lines.emplace_back(line); });
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    return line.find("tetgen: ") == 0 && line.find("Mesh tetrahedra") != std::string::npos;
  }));
}

TEST(Tetrahedralize, SaysWhereSurfacesIntersect) {
  SurfaceComplex surface = cube_surface();
  const SurfaceComplex other = cube_surface();
  for (const Vec3& p : other.points) surface.points.push_back(p + Vec3(0.4, 0.3, 0.2));
  for (SurfaceFacet facet : other.facets) {
    for (int& point : facet.polygons[0]) point += 8;
    surface.facets.push_back(facet);
  }
  TetrahedraOptions options;
  options.origin = {"room.toml", 7, "mesh"};
  const std::string message = message_of(surface, options);
  EXPECT_EQ(message.find("room.toml:7: mesh: surfaces intersect each other (triangle ("), 0u) << message;
  EXPECT_NE(message.find("parts may touch along whole facets only"), std::string::npos) << message;
}

TEST(Tetrahedralize, RefusesAnOpenSurface) {
  SurfaceComplex surface = cube_surface();
  surface.facets.pop_back();
  TetrahedraOptions options;
  options.origin = {"room.toml", 7, "mesh"};
  EXPECT_EQ(
      message_of(surface, options),
      "room.toml:7: mesh: the surface holds no volume (it is not closed, or all of it is a hole); give a "
      "closed surface");
}

TEST(Tetrahedralize, RefusesAPartWithoutRegion) {
  SurfaceComplex surface = two_region_surface();
  surface.seeds.pop_back();
  const std::string message = message_of(surface);
  EXPECT_EQ(message.find("the part around (0."), 0u) << message;
  EXPECT_NE(message.find("belongs to no region; give a point inside it"), std::string::npos) << message;
}

TEST(Tetrahedralize, RefusesARegionWithoutPart) {
  SurfaceComplex surface = two_region_surface();
  surface.seeds[1].point = {0.1, 0.1, 0.1};
  surface.seeds.push_back({Vec3::Constant(0.5), 0});
  surface.seeds.push_back({Vec3::Constant(0.1), 0});
  EXPECT_EQ(
      message_of(surface),
      "region \"inner\" got no cells (its point (0.1, 0.1, 0.1) lies outside, or in the same part as that of "
      "another region); give a point inside a part of its own");
}

TEST(Tetrahedralize, RefusesARegionWhosePointLiesOutside) {
  SurfaceComplex surface = two_region_surface();
  surface.seeds[1].point = {3, 3, 3};
  EXPECT_EQ(message_of(surface),
            "the point (3, 3, 3) of region \"inner\" lies outside the surface; give a point inside");
}

TEST(Tetrahedralize, RefusesAnImpossibleQuality) {
  TetrahedraOptions options;
  options.quality = 0.5;
  options.origin = {"room.toml", 7, "mesh"};
  EXPECT_EQ(message_of(cube_surface(), options),
            "room.toml:7: mesh.quality = 0.5: is too small (refinement would not end); use 1.1 or more");
}

TEST(Tetrahedralize, RefusesNothing) {
  EXPECT_EQ(message_of({}), "the geometry has no surface; give a closed surface");
  SurfaceComplex surface = cube_surface();
  surface.seeds.clear();
  EXPECT_EQ(message_of(surface), "the geometry has no region; give a region a volume");
}

TEST(Tetrahedralize, RefusesFlatInput) {
  SurfaceComplex surface;
  surface.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  surface.facets.push_back({{{0, 1, 2, 3}}, {}, 0});
  surface.wall_names = {"w"};
  surface.region_names = {"r"};
  surface.seeds.push_back({{0.5, 0.5, 0.5}, 0});
  EXPECT_EQ(message_of(surface), "the geometry is flat (from (0, 0, 0) to (1, 1, 0)); give a closed surface");
}

TEST(Tetrahedralize, RefusesFacetsOfPointsThatAreNotThere) {
  SurfaceComplex surface = cube_surface();
  surface.facets[0].polygons[0][0] = 1000000;
  EXPECT_NE(message_of(surface), "no error");
}

}  // namespace
}  // namespace etendue::tetrahedralize_test
