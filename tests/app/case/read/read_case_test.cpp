// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/app/case/case_text.h"

namespace etendue::read_case_test {
namespace {

const std::string smoke_room = R"toml(title = "Smoke in a room"

[units]
length = "cm"
power  = "1/s"

[mesh]
max_volume  = { "*" = 1e-3, smoke = 1e-4 }
quality     = 1.5

[[mesh.box]]
region = "air"
min = [0, 0, 0]
max = [4, 3, 2.5]
walls = { zmin = "floor", zmax = "ceiling" }

[[mesh.sphere]]
region = "smoke"
center = [2, 1.5, 1]
radius = 0.6

[[mesh.box]]
hole = true
name = "crate"
min = [0.2, 0.2, 0.1]
max = [0.6, 0.6, 0.5]

[[mesh.cylinder]]
region = "smoke"
from = [1, 1, 0.5]
to = [1, 1, 2]
radius = 0.1
facets = 12

[[mesh.patch]]
wall = "lamp"
min = [1.5, 1, 2.5]
max = [2.5, 2, 2.5]

[bands]
names = ["red", "green", "blue"]
edges = [700, 600, 500, 400]

[media.smoke]
absorption = [0.1, "0.1 + 0.05*sin(3*x)", 0.3]
scattering = 2.0
phase      = { model = "henyey-greenstein", g = 0.6 }
power_density = 4
uncollided = "auto"
[media."*"]

[walls.floor]
diffuse  = [0.7, 0.6, 0.5]
specular = 0.1
uncollided = false
[walls.lamp]
radiance = [12, 11, 9]
[walls."*"]

[directions]
set   = "product"
order = 4

[space]
order   = 0
lumping = "none"

[solve]
method       = "source-iteration"
acceleration = "none"
tolerance    = 1e-7
max_sweeps   = 50
threads      = 2

[[probe]]
name = "axis"
points = [[1, 1, 1], [1, 2, 1]]
[[probe]]
name = "wall-line"
line = { from = [0, 0, 0], to = [1, 0, 0], count = 5 }
normal = [0, 0, 2]

[output]
directory  = "results"
fields     = ["fluence", "radiance:3", "media"]
)toml";

double number(const BandValues& values, std::size_t i) { return std::get<double>(values.values.at(i)); }

TEST(CaseReader, ReadsEveryKey) {
  const TestFolder folder;
  const Case room = read_case(folder.write("room.toml", smoke_room));
  EXPECT_EQ(room.title, "Smoke in a room");
  EXPECT_EQ(room.units.length, "cm");
  EXPECT_EQ(room.units.power, "1/s");
  EXPECT_EQ(room.mesh.max_volume->by_region, (std::map<std::string, double>{{"*", 1e-3}, {"smoke", 1e-4}}));
  EXPECT_EQ(room.mesh.max_volume->origin.line, 8);
  EXPECT_EQ(room.mesh.quality, 1.5);
  EXPECT_EQ(room.bands.names, (std::vector<std::string>{"red", "green", "blue"}));
  EXPECT_EQ(room.bands.edges, (std::vector<double>{700, 600, 500, 400}));
  EXPECT_EQ(room.direction_set, "product");
  EXPECT_EQ(room.direction_order, 4);
  EXPECT_EQ(room.solve.order, SpaceOrder::constant);
  EXPECT_EQ(room.solve.lumping, Lumping::none);
  EXPECT_EQ(room.solve.tolerance, 1e-7);
  EXPECT_EQ(room.solve.max_sweeps, 50);
  EXPECT_EQ(room.solve.threads, 2);
  EXPECT_EQ(room.solve.keep_ordinates, std::vector<int>{3});
  EXPECT_EQ(room.output.radiance_ordinates, std::vector<int>{3});
  EXPECT_EQ(room.output.fields, (std::vector<std::string>{"fluence", "radiance:3", "media"}));
  EXPECT_EQ(room.output.directory, folder.path() / "results");
}

TEST(CaseReader, KeepsThePrimitivesInTheOrderOfTheFile) {
  const Geometry geometry = case_of(smoke_room).mesh.geometry;
  ASSERT_EQ(geometry.primitives.size(), 4);
  const auto& air = std::get<BoxPrimitive>(geometry.primitives[0]);
  EXPECT_EQ(air.region, "air");
  EXPECT_EQ(air.max, Vec3(4, 3, 2.5));
  EXPECT_EQ(air.walls, (std::map<std::string, std::string>{{"zmin", "floor"}, {"zmax", "ceiling"}}));
  EXPECT_EQ(air.origin.line, 11);
  const auto& smoke = std::get<SpherePrimitive>(geometry.primitives[1]);
  EXPECT_EQ(smoke.center, Vec3(2, 1.5, 1));
  EXPECT_EQ(smoke.radius, 0.6);
  EXPECT_EQ(smoke.facets, 320);
  const auto& crate = std::get<BoxPrimitive>(geometry.primitives[2]);
  EXPECT_TRUE(crate.hole);
  EXPECT_EQ(crate.name, "crate");
  const auto& pipe = std::get<CylinderPrimitive>(geometry.primitives[3]);
  EXPECT_EQ(pipe.to, Vec3(1, 1, 2));
  EXPECT_EQ(pipe.facets, 12);
  ASSERT_EQ(geometry.patches.size(), 1);
  EXPECT_EQ(geometry.patches[0].wall, "lamp");
}

TEST(CaseReader, ReadsMediaAndWallsPerBand) {
  const Case room = case_of(smoke_room);
  const MediumCase& smoke = room.media.at("smoke");
  EXPECT_EQ(number(*smoke.absorption, 2), 0.3);
  EXPECT_EQ(std::get<Formula>(smoke.absorption->values[1]).text, "0.1 + 0.05*sin(3*x)");
  EXPECT_EQ(smoke.phase, std::vector<PhaseFunction>{PhaseHenyeyGreenstein{0.6}});
  EXPECT_EQ(number(*smoke.power_density, 0), 4);
  EXPECT_TRUE(room.media.contains("*"));
  const WallCase& floor = room.walls.at("floor");
  EXPECT_EQ(number(floor.diffuse, 1), 0.6);
  EXPECT_EQ(number(floor.specular, 0), 0.1);
  EXPECT_EQ(number(floor.radiance, 0), 0);
  EXPECT_EQ(number(room.walls.at("lamp").radiance, 2), 9);
}

TEST(CaseReader, SpreadsALineOfProbes) {
  const std::vector<Probe> probes = case_of(smoke_room).probes;
  ASSERT_EQ(probes.size(), 2);
  EXPECT_EQ(probes[0].points[1], Vec3(1, 2, 1));
  EXPECT_FALSE(probes[0].normal);
  ASSERT_EQ(probes[1].points.size(), 5);
  EXPECT_EQ(probes[1].points[0], Vec3(0, 0, 0));
  EXPECT_EQ(probes[1].points[1], Vec3(0.25, 0, 0));
  EXPECT_EQ(probes[1].points[4], Vec3(1, 0, 0));
  EXPECT_EQ(*probes[1].normal, Vec3(0, 0, 1));
}

TEST(CaseReader, FillsInDefaults) {
  const Case air = case_of(cube);
  EXPECT_EQ(air.units.length, "m");
  EXPECT_EQ(air.bands.names, std::vector<std::string>{"grey"});
  EXPECT_EQ(air.mesh.quality, 1.4);
  EXPECT_FALSE(air.mesh.max_volume);
  EXPECT_EQ(air.direction_set, "ldfe-sq");
  EXPECT_EQ(air.direction_order, 1);
  EXPECT_EQ(air.solve.order, SpaceOrder::linear);
  EXPECT_EQ(air.solve.lumping, Lumping::automatic);
  EXPECT_EQ(air.solve.tolerance, 1e-6);
  EXPECT_EQ(air.solve.max_sweeps, 500);
  EXPECT_EQ(air.output.fields, (std::vector<std::string>{"fluence", "net_flux"}));
  EXPECT_EQ(air.output.directory, "slab");
  EXPECT_EQ(air.output.encoding, VtkEncoding::inline_base64);
  EXPECT_EQ(case_of(cube + "[output]\nencoding = \"appended\"\n").output.encoding, VtkEncoding::appended_raw);
}

TEST(CaseReader, NamesTheResultsOfCaseTomlByItsFolder) {
  const TestFolder folder;
  EXPECT_EQ(read_case(folder.write("case.toml", cube)).output.directory, folder.path().filename());
}

TEST(CaseReader, FindsFilesBesideTheCaseAndThoseOfTheCommandLineInTheWorkingDirectory) {
  const TestFolder folder;
  const auto file =
      folder.write("slab.toml", no_geometry + "[mesh]\nfile = \"sub/../room.msh\"\nscale = 0.01\n");
  const Case room = read_case(file);
  EXPECT_EQ(room.mesh.file->path, folder.path() / "room.msh");
  EXPECT_EQ(room.mesh.file->origin.line, 4);
  EXPECT_EQ(room.mesh.scale, 0.01);
  EXPECT_EQ(read_case(file, {"mesh.file=other.msh"}).mesh.file->path, "other.msh");
  EXPECT_EQ(read_case(file, {"output.directory=out"}).output.directory, "out");
}

TEST(CaseReader, ReadsASurfaceWithItsRegions) {
  const Case room =
      case_of(no_geometry +
              "[mesh]\nsurface = \"/tmp/room.stl\"\nedge_length = 0.1\nregions = { air = [1, 2, 3] }\n");
  EXPECT_EQ(room.mesh.surface->path, "/tmp/room.stl");
  EXPECT_EQ(room.mesh.edge_length->by_region.at("*"), 0.1);
  EXPECT_EQ(room.mesh.regions.at("air"), Vec3(1, 2, 3));
}

TEST(CaseReader, ReadsAPhaseFunctionForEachBand) {
  const Case air = case_of(cube + R"([bands]
names = ["red", "blue"]
[media.air]
scattering = 1
phase = [{ model = "isotropic" }, { model = "henyey-greenstein", g = -0.5 }]
)");
  EXPECT_EQ(air.media.at("air").phase,
            (std::vector<PhaseFunction>{PhaseIsotropic{}, PhaseHenyeyGreenstein{-0.5}}));
}

TEST(CaseReader, ReadsARotationOfTheDirections) {
  EXPECT_FALSE(case_of(cube).direction_rotation);
  const std::string directions = cube + "[directions]\nrotation = ";
  const Case turned = case_of(directions + "{ axis = [0, 0, 2], angle = 90 }\n");
  EXPECT_LT((*turned.direction_rotation * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_EQ(case_of(directions + "\"random\"\nseed = 5\n").direction_rotation, random_rotation(5));
  EXPECT_EQ(case_of(directions + "\"random\"\n").direction_rotation, random_rotation(1));
}

TEST(ResolvedCase, ReadsBackTheSame) {
  const std::string surface = no_geometry + "[mesh]\nsurface = \"/tmp/room.stl\"\n";
  const std::string mixed =
      cube +
      "[media.air]\nextinction = 2\nalbedo = 0.5\n[media.b]\nextinction = 1\nscattering = 1\n"
      "[[mesh.box]]\nregion = \"b\"\nmin = [0, 0, 0]\nmax = [0.5, 1, 1]\n";
  const std::string random = cube + "[directions]\nrotation = \"random\"\n";
  const std::string turned = cube + "[directions]\nrotation = { axis = [1, 2, 3], angle = 20 }\n";
  const std::string mixture = cube +
                              "[media.air]\nscattering = 1\nphase = { model = \"mixture\", mix = [{ weight = "
                              "1, model = \"rayleigh\" }, "
                              "{ weight = 3, model = \"henyey-greenstein\", g = 0.7 }] }\n";
  for (const std::string& text : {cube, smoke_room, surface, mixed, random, turned, mixture}) {
    const std::string resolved = case_of(text).resolved_toml;
    EXPECT_EQ(faults_of(resolved), "") << resolved;
    EXPECT_EQ(case_of(resolved).resolved_toml, resolved);
  }
}

TEST(ResolvedCase, HasOverridesAndDefaults) {
  const std::string resolved = case_of(cube, {"solve.tolerance=1e-9"}).resolved_toml;
  for (const char* line :
       {"tolerance = 1e-09\n", "max_sweeps = 500\n", "set = \"ldfe-sq\"\n", "names = [\"grey\"]\n",
        "directory = \"slab\"\n", "absorption = 0.0\n", "diffuse = 0.0\n"})
    EXPECT_NE(resolved.find(line), std::string::npos) << line << resolved;
}

TEST(CaseReader, SurvivesACutAnywhere) {
  for (std::size_t length = 0; length < smoke_room.size(); length += 7) {
    const std::string faults = faults_of(smoke_room.substr(0, length));
    EXPECT_TRUE(faults.empty() || faults.starts_with("slab.toml")) << faults;
  }
}

}  // namespace
}  // namespace etendue::read_case_test
