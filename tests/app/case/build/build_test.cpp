// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/build.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/files/mesh_file.h"
#include "tests/app/case/build/build_faults.h"
#include "tests/app/case/case_text.h"

namespace etendue::build_test {
namespace {

using test::build_faults;

// A lit room of air with a block of smoke in it.
const std::string room = R"([mesh]
max_volume = { "*" = 0.05, smoke = 0.002 }
[[mesh.box]]
region = "air"
min = [0, 0, 0]
max = [1, 1, 1]
walls = { zmin = "floor" }
[[mesh.box]]
region = "smoke"
min = [0.25, 0.25, 0.25]
max = [0.75, 0.75, 0.75]
[[mesh.patch]]
wall = "lamp"
min = [0.25, 0.25, 1]
max = [0.75, 0.75, 1]
[bands]
names = ["red", "blue"]
[media.smoke]
extinction = [2, 4]
albedo = 0.75
phase = { model = "henyey-greenstein", g = 0.6 }
power = 3
[media."*"]
absorption = ["x", 0.5]
power_density = 2
[walls.floor]
diffuse = [0.5, 0.25]
[walls.lamp]
radiance = 3
[walls."*"]
specular = 1
)";

int index_of(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<int>(std::ranges::find(names, name) - names.begin());
}

TEST(BuildMesh, FillsThePrimitivesWithinTheirVolumeBounds) {
  const TetrahedralMesh mesh = build_mesh(case_of(room));
  double smoke_volume = 0;
  for (int c = 0; c < mesh.cell_count(); ++c) {
    const CellIndex cell(c);
    const bool smoke = mesh.region_names()[static_cast<std::size_t>(mesh.region(cell))] == "smoke";
    EXPECT_LE(mesh.volume(cell), (smoke ? 0.002 : 0.05) * (1 + 1e-9));
    if (smoke) smoke_volume += mesh.volume(cell);
  }
  EXPECT_NEAR(smoke_volume, 0.125, 1e-12);
}

TEST(BuildMesh, BoundsVolumesByAnEdgeLength) {
  const TetrahedralMesh mesh = build_mesh(case_of(cube, {"mesh.edge_length=0.5"}));
  for (int c = 0; c < mesh.cell_count(); ++c)
    EXPECT_LE(mesh.volume(CellIndex(c)), 0.125 / (6 * std::numbers::sqrt2) * (1 + 1e-9));
}

TEST(BuildMesh, ReportsNamesBeforeMeshing) {
  // The inner box names a side that does not end up on the outside.
  EXPECT_EQ(build_faults(case_of(room, {"walls.flor.diffuse=1", "mesh.box[1].walls={zmin='flor'}"})),
            "0: walls.flor: no wall of the mesh is called \"flor\" (did you mean \"floor\"?); there are "
            "floor, lamp, xmax, xmin, ymax, ymin, zmax\n"
            "8: mesh.box[1].walls.zmin: no wall of the mesh is called \"flor\" (did you mean \"floor\"?); "
            "there are "
            "floor, lamp, xmax, xmin, ymax, ymin, zmax\n");
}

TEST(BuildMesh, ReadsAScaledFile) {
  const TestFolder folder;
  write_mesh(folder.path() / "cube.vtu", build_mesh(case_of(cube)));
  const auto file = folder.write("slab.toml", no_geometry + "[mesh]\nfile = \"cube.vtu\"\nscale = 2\n");
  const TetrahedralMesh mesh = build_mesh(read_case(file));
  double volume = 0;
  for (const double cell : mesh.volumes()) volume += cell;
  EXPECT_NEAR(volume, 8, 1e-12);
  EXPECT_EQ(mesh.region_names(), std::vector<std::string>{"air"});
}

TEST(BuildMesh, ChecksTheNamesOfAFile) {
  const TestFolder folder;
  write_mesh(folder.path() / "cube.vtu", build_mesh(case_of(cube)));
  const auto file = folder.write("slab.toml", "[mesh]\nfile = \"cube.vtu\"\n[media.smoke]\n[walls.\"*\"]\n");
  EXPECT_EQ(build_faults(read_case(file)),
            "0: media.air: missing (the mesh has this region); add an entry for it, or \"*\"\n"
            "3: media.smoke: no region of the mesh is called \"smoke\"; there are air\n");
}

TEST(BuildProblem, NamesTheKernelAndADirectionWhereItScattersMoreThanTheExtinction) {
  // sigma_s = 0.4 pi in all directions, though the second has a momentum of its own.
  for (const char* const kernel : {"0.1", "0.1*(1+wz*vz)"}) {
    const std::string faults =
        build_faults(case_of(cube + "[media.air]\nkernel = \"" + kernel + "\"\nextinction = 1\n"));
    EXPECT_EQ(
        faults.rfind("7: media.air.kernel: the kernel scatters 1.25664 of each unit of length out of the "
                     "direction (",
                     0),
        0u)
        << faults;
  }
}

TEST(BuildProblem, RefusesTheKernelsThatARunRefuses) {
  EXPECT_EQ(build_faults(case_of(cube + "[media.air]\nkernel = \"0.1 + 0.2*vx\"\nabsorption = 1\n"))
                .rfind("7: media.air.kernel: the kernel is -", 0),
            0u);
  EXPECT_NE(build_faults(case_of(cube + "[media.air]\nkernel = \"0.1*(2 + vx)\"\nreciprocal = true\n"))
                .find("it is not reciprocal"),
            std::string::npos);
}

TEST(BuildProblem, TakesAKernelThatIsNoProductWithItsMeanOverTheRegion) {
  const std::string kernel = "[media.air]\nkernel = \"(1+x)*(1+0.5*x*wx*vx)/(4*pi)\"\n";
  const Case input = case_of(cube + kernel);
  const TetrahedralMesh mesh = build_mesh(input);
  const Problem problem = build_problem(input, mesh);
  double mean = 0;
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (const std::int32_t v : mesh.vertices(CellIndex(c)))
      mean += (1 + mesh.point(VertexIndex(v)).x()) / 4 / mesh.cell_count();
  EXPECT_NEAR(problem.scattering(CellIndex(0), 0), mean, 0.1 * mean);
  EXPECT_NE(build_faults(case_of(cube + kernel + "extinction = \"2 + wx\"\n"))
                .find("the kernel depends on the place and extinction is given beside it"),
            std::string::npos);
}

TEST(CheckKernels, RefusesWithoutAMeshWhatARunRefuses) {
  const auto refused = [](const std::string& kernel) {
    try {
      check_kernels(case_of(cube + "[media.air]\n" + kernel));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(
      refused("kernel = \"0.1\"\nextinction = 1\n").find("media.air.kernel: the kernel scatters 1.25664"),
      std::string::npos);
  EXPECT_NE(refused("kernel = \"vx\"\n").find("media.air.kernel: the kernel is -"), std::string::npos);
  EXPECT_EQ(refused("kernel = \"0.1\"\nextinction = 2\n"), "");
}

TEST(BuildProblem, GivesEachRegionItsMedium) {
  const Case input = case_of(room);
  const TetrahedralMesh mesh = build_mesh(input);
  const Problem problem = build_problem(input, mesh);
  const Medium& smoke = problem.medium(index_of(mesh.region_names(), "smoke"));
  EXPECT_EQ(smoke.scattering[1].at(Vec3::Zero()), 3);
  EXPECT_EQ(smoke.absorption[1].at(Vec3::Zero()), 1);
  EXPECT_EQ(smoke.phase[1], PhaseFunction(PhaseHenyeyGreenstein{0.6}));
  const Medium& air = problem.medium(index_of(mesh.region_names(), "air"));
  EXPECT_EQ(air.absorption[0].at(Vec3(0.25, 0, 0)), 0.25);
  EXPECT_EQ(air.absorption[1].at(Vec3(0.25, 0, 0)), 0.5);
  EXPECT_DOUBLE_EQ(air.emission[0].at(Vec3::Zero()), 2 / (4 * std::numbers::pi));
}

TEST(BuildProblem, SpreadsThePowerOfARegionOverItsMeshedVolume) {
  const Case input = case_of(room);
  const TetrahedralMesh mesh = build_mesh(input);
  const Problem problem = build_problem(input, mesh);
  const int smoke = index_of(mesh.region_names(), "smoke");
  double power = 0;
  for (int c = 0; c < mesh.cell_count(); ++c)
    if (mesh.region(CellIndex(c)) == smoke)
      power += 4 * std::numbers::pi * problem.emission(CellIndex(c), 1) * mesh.volume(CellIndex(c));
  EXPECT_NEAR(power, 3, 1e-12);
}

TEST(BuildProblem, OfFlatlandSpreadsPowerOverTheDirectionsOfThePlane) {
  const Case input = case_of(
      "[[mesh.box]]\nregion = \"air\"\nmin = [0, 0, 0]\nmax = [1, 1, 0.5]\n"
      "[media.air]\nabsorption = 1\npower_density = 6\n[walls.\"*\"]\n[walls.zmin]\nspecular = 1\n"
      "[walls.zmax]\nspecular = 1\n[directions]\nset = \"flatland\"\norder = 8\n");
  const TetrahedralMesh mesh = build_mesh(input);
  const Problem problem = build_problem(input, mesh);
  EXPECT_EQ(problem.space(), AngularSpace::plane);
  EXPECT_DOUBLE_EQ(problem.emission(CellIndex(0), 0), 6 / (2 * std::numbers::pi));
  EXPECT_EQ(build_directions(input).space(), AngularSpace::plane);
}

TEST(BuildProblem, GivesEachWallItsEntryOrThatOfTheRest) {
  const Case input = case_of(room);
  const TetrahedralMesh mesh = build_mesh(input);
  const Problem problem = build_problem(input, mesh);
  EXPECT_EQ(problem.wall(index_of(mesh.wall_names(), "floor")).diffuse, (std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(problem.wall(index_of(mesh.wall_names(), "floor")).specular, (std::vector<double>{0, 0}));
  EXPECT_EQ(problem.wall(index_of(mesh.wall_names(), "lamp")).radiance, (std::vector<double>{3, 3}));
  EXPECT_EQ(problem.wall(index_of(mesh.wall_names(), "ymin")).specular, (std::vector<double>{1, 1}));
}

TEST(BuildProblem, KeepsEmissionAndRadianceThatDependOnTheDirection) {
  const Case input = case_of(cube + R"([media.air]
absorption = 1
emission = "2 + wz*x"
[walls.zmin]
radiance = "max(0, wz)*y"
[walls.zmax]
radiance = "x"
)");
  const TetrahedralMesh mesh = build_mesh(input);
  const Problem problem = build_problem(input, mesh);
  const Medium& air = problem.media()[0];
  EXPECT_EQ(problem.emission(CellIndex(0), 0), 0);
  EXPECT_DOUBLE_EQ(air.emission_by_direction[0]->at(Vec3(0.5, 0, 0), Vec3(0, 0, -1)), 1.5);
  for (const Wall& wall : problem.walls()) {
    EXPECT_EQ(wall.radiance[0], 0);
    const auto& formula = wall.radiance_by_direction;
    if (wall.name == "zmin") {
      EXPECT_DOUBLE_EQ(formula[0]->at(Vec3(0, 0.5, 0), Vec3(0, 0.6, 0.8)), 0.4);
    } else if (wall.name == "zmax") {
      EXPECT_DOUBLE_EQ(formula[0]->at(Vec3(0.25, 0, 0), Vec3(0, 0, 1)), 0.25);
    } else {
      EXPECT_FALSE(formula[0].has_value());
    }
  }
}

}  // namespace
}  // namespace etendue::build_test
