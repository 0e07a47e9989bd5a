// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/build/build.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/files/mesh_file.h"
#include "solver/problem/lights/lamp_shape.h"
#include "solver/problem/mirror.h"
#include "tests/app/case/case_text.h"

namespace etendue::build_test {
namespace {

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

std::string build_faults(const Case& input) {
  try {
    build_problem(input, build_mesh(input));
    return "";
  } catch (const InputError& error) {
    std::string faults;
    for (const Fault& fault : error.faults()) faults += std::to_string(fault.line) + ": " + fault.text + "\n";
    return faults;
  }
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

/// A lamp with one bright place at these vertical and horizontal angles, as it is built.
PointLight lamp_of_type(int type, const std::string& vertical, const std::string& horizontal, int bright) {
  const TestFolder folder;
  std::string text = "IESNA91\nTILT=NONE\n1 1 1 3 3 " + std::to_string(type) + " 2 0 0 0\n1 1 1\n" +
                     vertical + "\n" + horizontal + "\n";
  for (int i = 0; i < 9; ++i) text += i == bright ? "1 " : "0 ";
  const Case input =
      case_of(cube + "[[light]]\nname = \"lamp\"\nkind = \"point\"\nposition = [0.5, 0.5, 0.5]\n" +
              "power = 1\ndistribution = \"" + folder.write("lamp.ies", text).string() + "\"\n");
  const TetrahedralMesh mesh = build_mesh(input);
  return std::get<PointLight>(build_problem(input, mesh).lights()[0].kind);
}

// Photometric zero is -z and photometric horizontal x: type C turns counterclockwise from above, A and B turn
// clockwise, and the planes of B meet in the horizontal.
TEST(BuildProblem, TurnsIesLampsByTheirType) {
  const auto brightness = [](const PointLight& lamp, const Vec3& direction) {
    return lamp_shape(lamp, direction);
  };
  const PointLight c = lamp_of_type(1, "0 90 180", "0 90 180", 4);
  EXPECT_NEAR(brightness(c, Vec3::UnitY()), 1, 1e-12);
  EXPECT_NEAR(brightness(c, Vec3(0.6, 0.8, 0)), std::atan2(0.8, 0.6) / (std::numbers::pi / 2), 1e-12);
  EXPECT_NEAR(brightness(c, -Vec3::UnitY()), 1, 1e-12);
  EXPECT_NEAR(brightness(c, Vec3::UnitX()), 0, 1e-12);
  const PointLight a = lamp_of_type(3, "-90 0 90", "-90 0 90", 7);
  EXPECT_NEAR(brightness(a, -Vec3::UnitY()), 1, 1e-12);
  EXPECT_NEAR(brightness(a, Vec3::UnitY()), 0, 1e-12);
  EXPECT_NEAR(brightness(a, Vec3(0, -0.8, -0.6)), std::atan2(0.8, 0.6) / (std::numbers::pi / 2), 1e-12);
  const PointLight horizontal = lamp_of_type(3, "-90 0 90", "-90 0 90", 4);
  EXPECT_NEAR(brightness(horizontal, Vec3::UnitX()), 1, 1e-12);
  const PointLight b = lamp_of_type(2, "-90 0 90", "-90 0 90", 7);
  EXPECT_NEAR(brightness(b, -Vec3::UnitY()), 1, 1e-12);
  EXPECT_NEAR(brightness(b, Vec3(0, -0.8, -0.6)), std::atan2(0.8, 0.6) / (std::numbers::pi / 2), 1e-12);
  const PointLight down = lamp_of_type(2, "-90 0 90", "-90 0 90", 4);
  EXPECT_NEAR(brightness(down, -Vec3::UnitZ()), 1, 1e-12);
  const PointLight ahead = lamp_of_type(2, "-90 0 90", "-90 0 90", 5);
  EXPECT_NEAR(brightness(ahead, Vec3::UnitX()), 1, 1e-12);
}

/// A sky over a cube from this table.
std::vector<BeamLight> sky_of(const std::string& table, const std::string& keys) {
  const TestFolder folder;
  const Case input =
      case_of(cube + "[[light]]\nname = \"sky\"\nkind = \"sky\"\nradiance = 3\ndistribution = \"" +
              folder.write("sky.csv", table).string() + "\"\n" + keys);
  const TetrahedralMesh mesh = build_mesh(input);
  const Problem problem = build_problem(input, mesh);
  std::vector<BeamLight> parts;
  for (const Light& light : problem.lights()) parts.push_back(std::get<BeamLight>(light.kind));
  return parts;
}

TEST(BuildProblem, LightsLevelGroundAsAnEvenSkyDoes) {
  double all = 0, on_the_ground = 0;
  for (const BeamLight& part : sky_of("0, 1\n90, 1\n", "")) {
    all += part.irradiance[0];
    on_the_ground -= part.irradiance[0] * part.direction.z();
  }
  EXPECT_NEAR(all, 3 * 2 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(on_the_ground, 3 * std::numbers::pi, 1e-12);
}

// Bright at azimuth 90 alone, which lies counterclockwise of `along` as seen from above: light from there
// travels the other way.
TEST(BuildProblem, TurnsTheTableOfASky) {
  const std::string table =
      "angle, azimuth, radiance\n0, 0, 0\n0, 90, 0\n0, 180, 0\n90, 0, 0\n90, 90, 1\n90, 180, 0\n";
  const auto flow = [&](const std::string& keys) {
    Vec3 sum = Vec3::Zero();
    for (const BeamLight& part : sky_of(table, keys)) sum += part.irradiance[0] * part.direction;
    return sum.normalized().eval();
  };
  const Vec3 from_y = flow("");
  EXPECT_NEAR(from_y.x(), 0, 1e-12);
  EXPECT_LT(from_y.y(), -0.7);
  EXPECT_LT(from_y.z(), -0.2);
  const Vec3 from_minus_x = flow("along = [0, 1, 0]\n");
  EXPECT_NEAR(from_minus_x.x(), -from_y.y(), 1e-12);
  EXPECT_NEAR(from_minus_x.z(), from_y.z(), 1e-12);
}

const std::string pool = R"([mesh]
max_volume = 0.2
[[mesh.box]]
region = "water"
min = [0, 0, 0]
max = [1, 1, 1]
walls = { zmax = "surface" }
[media.water]
absorption = 1
[walls.surface]
refractive_index = 1.33
[walls."*"]
)";

std::string sun(const std::string& keys) {
  return pool + "[[light]]\nname = \"sun\"\nkind = \"sun\"\nirradiance = 2\n" + keys;
}

// Snell's law; of glancing light more is turned back. The power through the surface is the remainder.
TEST(BuildProblem, RefractsTheSunAtASurface) {
  const Case input = case_of(sun("direction = [0.8, 0, -0.6]\nwalls = [\"surface\"]\n"));
  const TetrahedralMesh mesh = build_mesh(input);
  const Problem problem = build_problem(input, mesh);
  const auto beam = std::get<BeamLight>(problem.lights().front().kind);
  EXPECT_NEAR(beam.direction.x(), 0.8 / 1.33, 1e-12);
  EXPECT_NEAR(beam.direction.norm(), 1, 1e-12);
  EXPECT_NEAR(beam.irradiance[0] * -beam.direction.z(), 2 * 0.6 * (1 - fresnel_reflectance(0.6, 1 / 1.33)),
              1e-12);
}

// The axis meets the surface at x = 0.4 + 0.4/3 and continues by Snell's law; along the wall the
// cross-section stays.
TEST(BuildProblem, RefractsTheCrossSectionOfABeam) {
  const Case input = case_of(
      pool +
      "[[light]]\nname = \"laser\"\nkind = \"beam\"\nposition = [0.4, 0.5, 1.1]\ndirection = [0.8, 0, "
      "-0.6]\nradius = 0.2\nprofile = \"gaussian\"\npower = 3\nwalls = [\"surface\"]\n");
  const TetrahedralMesh mesh = build_mesh(input);
  const Problem problem = build_problem(input, mesh);
  const auto beam = std::get<BeamLight>(problem.lights().front().kind);
  const Vec3 entry(0.4 + 0.8 / 6, 0.5, 1);
  EXPECT_NEAR(relative_irradiance(*beam.profile, entry + 0.7 * beam.direction), 1, 1e-12);
  // 0.1 along the wall in the plane of incidence is 0.06 across the beam outside.
  EXPECT_NEAR(relative_irradiance(*beam.profile, entry + 0.1 * Vec3::UnitX() + 0.7 * beam.direction),
              std::exp(-2 * 0.09), 1e-12);
  EXPECT_NEAR(beam.irradiance[0] * -beam.direction.z(),
              3 / (std::numbers::pi * 0.02) * 0.6 * (1 - fresnel_reflectance(0.6, 1 / 1.33)), 1e-9);
}

TEST(BuildProblem, RefusesABeamThatMissesItsWalls) {
  const std::string faults = build_faults(
      case_of(pool +
              "[[light]]\nname = \"laser\"\nkind = \"beam\"\nposition = [2, 0.5, 3]\ndirection = [0, 0, -1]\n"
              "radius = 0.2\npower = 3\nwalls = [\"surface\"]\n"));
  EXPECT_NE(faults.find("the light \"laser\" misses the walls by which it may come in"), std::string::npos)
      << faults;
}

TEST(BuildProblem, RefusesASunByASurfaceAndByOtherWalls) {
  EXPECT_NE(build_faults(case_of(sun("direction = [0.8, 0, -0.6]\n")))
                .find("comes in by the wall surface, which refracts, and by others; name one wall"),
            std::string::npos);
  EXPECT_NE(build_faults(case_of(sun("direction = [0, 0, 1]\nwalls = [\"surface\"]\n")))
                .find("which refracts, from behind; turn the light"),
            std::string::npos);
}

TEST(BuildProblem, RefusesBeamsThatLeadOutOfTheDomain) {
  const auto of_floor = [](const std::string& direction) {
    return build_faults(case_of(cube + "[mesh]\nedge_length = 1\n[walls.zmin]\nbeam = { direction = " +
                                direction + ", irradiance = 1 }\n"));
  };
  EXPECT_NE(
      of_floor("[0, 0, -2]")
          .find("walls.zmin.beam: the light \"zmin.beam\" comes in by none of its walls (it travels along "
                "[0, 0, -1], out of the domain or along them); turn it"),
      std::string::npos)
      << of_floor("[0, 0, -2]");
  EXPECT_NE(of_floor("[1, 0, 0]"), "");
  EXPECT_EQ(of_floor("[1, 0, 0.1]"), "");
}

TEST(BuildProblem, RefusesALampOnAWallThatShinesAtIt) {
  const auto spot = [](const std::string& direction) {
    return build_faults(case_of(cube +
                                "[mesh]\nedge_length = 1\n[[light]]\nname = \"lamp\"\nkind = \"spot\"\n"
                                "position = [0.5, 0.5, 1]\npower = 1\nangle = 30\ndirection = " +
                                direction + "\n"));
  };
  EXPECT_NE(spot("[0, 0, 1]").find("the light \"lamp\" on a wall shines only at the wall"), std::string::npos)
      << spot("[0, 0, 1]");
  EXPECT_EQ(spot("[0, 0, -1]"), "");
  EXPECT_EQ(spot("[1, 0, 0]"), "");
}

// A black box in the room is none of the ways in.
TEST(BuildProblem, LetsTheSunInByOuterWallsOnly) {
  const Case input = case_of(R"([mesh]
max_volume = 0.2
[[mesh.box]]
region = "air"
min = [0, 0, 0]
max = [1, 1, 1]
[[mesh.box]]
hole = true
name = "crate"
min = [0.4, 0.4, 0.2]
max = [0.6, 0.6, 0.5]
[media.air]
[walls.zmin]
diffuse = 0.5
[walls."*"]
[[light]]
name = "sun"
kind = "sun"
direction = [0, 0, -1]
irradiance = 1
)");
  const TetrahedralMesh mesh = build_mesh(input);
  const Problem problem = build_problem(input, mesh);
  std::vector<std::string> names;
  for (const int wall : std::get<BeamLight>(problem.lights().front().kind).walls)
    names.push_back(mesh.wall_names()[static_cast<std::size_t>(wall)]);
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<std::string>{"xmax", "xmin", "ymax", "ymin", "zmax"}));
}

}  // namespace
}  // namespace etendue::build_test
