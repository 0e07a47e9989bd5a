// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Lamps, suns, skies and beams of a case as lights of its problem.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/case/build/build.h"
#include "solver/problem/lights/lamp_shape.h"
#include "solver/problem/mirror.h"
#include "tests/app/case/build/build_faults.h"
#include "tests/app/case/case_text.h"

namespace etendue::build_lights_test {
namespace {

using test::build_faults;

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

// The sun does not come in by the walls of a black box in the room.
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
}  // namespace etendue::build_lights_test
