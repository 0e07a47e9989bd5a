// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/read_heat_balance.h"

#include <gtest/gtest.h>

#include <numbers>

#include "app/case/build/build.h"
#include "app/case/build/build_heat.h"
#include "app/case/temperatures.h"
#include "tests/app/case/case_text.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue::read_heat_balance_test {
namespace {

constexpr double pi = std::numbers::pi;

std::string air(const std::string& keys) { return cube + "[media.air]\n" + keys; }
std::string floor_wall(const std::string& keys) { return cube + "[walls.zmin]\n" + keys; }
const std::string two_bands = "[bands]\nnames = [\"short\", \"long\"]\nedges = [1, 3000, 1e9]\n";

// 4 pi kappa I_b = kappa G + Q: what is absorbed is scattered, and Q is emitted.
TEST(ReadHeatBalance, MakesAMediumScatterWhatItAbsorbs) {
  const Case input = case_of(air("absorption = 0.5\nscattering = 1.5\nheat_source = 40\n"));
  EXPECT_TRUE(has_temperatures(input));
  const TetrahedralMesh mesh = build_mesh(input);
  const Problem problem = build_problem(input, mesh);
  ASSERT_EQ(problem.media().size(), 1u);
  EXPECT_EQ(problem.absorption(CellIndex(0), 0), 0);
  EXPECT_EQ(problem.scattering(CellIndex(0), 0), 2);
  EXPECT_NEAR(problem.emission(CellIndex(0), 0), 40 / (4 * pi), 1e-14);
  ASSERT_EQ(problem.medium(0).reradiation.size(), 1u);
  EXPECT_EQ(problem.medium(0).reradiation[0].at(Vec3::Zero()), 0.5);
  EXPECT_TRUE(std::holds_alternative<PhaseIsotropic>(problem.medium(0).phase[0]));
}

TEST(ReadHeatBalance, KeepsThePhaseFunctionOfWhatIsScattered) {
  const Case input =
      case_of(air("absorption = 0.5\nscattering = 1.5\nphase = { model = \"henyey-greenstein\", g = 0.8 "
                  "}\nheat_source = 0\n"));
  const TetrahedralMesh mesh = build_mesh(input);
  const Problem problem = build_problem(input, mesh);
  for (int degree = 0; degree < 5; ++degree)
    EXPECT_NEAR(phase_moment(problem.medium(0).phase[0], degree),
                (degree == 0 ? 0.25 : 0) + 0.75 * std::pow(0.8, degree), 1e-15)
        << degree;
}

TEST(ReadHeatBalance, MakesAnAdiabaticWallGiveBackWhatItAbsorbs) {
  const Case input = case_of(floor_wall("emissivity = 0.7\nspecular = 0.1\nheat_flux = 30\n"));
  EXPECT_TRUE(has_temperatures(input));
  const TetrahedralMesh mesh = build_mesh(input);
  const Problem problem = build_problem(input, mesh);
  int checked = 0;
  for (const Wall& wall : problem.walls()) {
    if (wall.name != "zmin") continue;
    EXPECT_NEAR(wall.diffuse[0], 0.9, 1e-15);
    EXPECT_NEAR(wall.specular[0], 0.1, 1e-15);
    EXPECT_NEAR(wall.radiance[0], 30 / pi, 1e-14);
    EXPECT_NEAR(wall.reradiation.at(0), 0.7, 1e-15);
    ++checked;
  }
  EXPECT_EQ(checked, 1);
}

TEST(ReadHeatBalance, IsReadAgainFromTheResolvedCase) {
  const std::string resolved =
      case_of(floor_wall(
                  "emissivity = 0.8\nheat_flux = 0\n[media.air]\nabsorption = 1\nheat_source = \"10*x\"\n"))
          .resolved_toml;
  EXPECT_EQ(faults_of(resolved), "") << resolved;
  EXPECT_TRUE(case_of(resolved).media.at("air").heat_source);
}

TEST(ReadHeatBalance, RefusesWhatHasNoTemperatureOfItsOwn) {
  EXPECT_NE(faults_of(air("absorption = 0\nheat_source = 1\n")).find("does not absorb"), std::string::npos);
  EXPECT_NE(
      faults_of(air("absorption = 1\ntemperature = 300\nheat_source = 1\n")).find("temperature is given too"),
      std::string::npos);
  EXPECT_NE(faults_of(air("absorption = 1\nemission = 2\nheat_source = 1\n")).find("emission is given too"),
            std::string::npos);
  EXPECT_NE(faults_of(air("absorption = \"1 + x\"\nscattering = 1\nphase = { model = \"rayleigh\" }\n"
                          "heat_source = 1\n"))
                .find("otherwise than isotropically"),
            std::string::npos);
  EXPECT_NE(faults_of(floor_wall("specular = 1\nheat_flux = 0\n")).find("does not absorb"),
            std::string::npos);
  EXPECT_NE(faults_of(floor_wall("radiance = 1\nheat_flux = 0\n")).find("radiance is given too"),
            std::string::npos);
}

TEST(ReadHeatBalance, IteratesWhereMediaConductOrBandsAreSeveral) {
  for (const std::string& text : {air("absorption = [1, 1]\nheat_source = 1\n") + two_bands,
                                  air("absorption = 1\nconductivity = \"0.1*(1 + x)\"\n")}) {
    const Case input = case_of(text);
    EXPECT_TRUE(has_temperatures(input));
    EXPECT_TRUE(iterates_temperatures(input));
    const TetrahedralMesh mesh = build_mesh(input);
    EXPECT_EQ(build_problem(input, mesh).absorption(CellIndex(0), 0), 1);
    const HeatProblem heat = build_heat(input, mesh).value();
    ASSERT_TRUE(heat.media.at(0));
    EXPECT_EQ(heat.media[0]->source.at(Vec3::Zero()), input.media.at("air").heat_source ? 1 : 0);
    EXPECT_EQ(heat.media[0]->conductivity.at(Vec3::UnitX(), 300),
              input.media.at("air").conductivity ? 0.2 : 0);
  }
  EXPECT_FALSE(iterates_temperatures(case_of(air("absorption = 1\nheat_source = 1\n"))));
}

TEST(ReadHeatBalance, IteratesWallsBesideConductorsBySeveralBandsOrConvection) {
  const std::string adiabatic = "emissivity = 0.7\nheat_flux = 30\n";
  const std::string convective = "emissivity = 0.7\nconvection = { h = 5, ambient = 290 }\n";
  for (const std::string& text :
       {floor_wall(convective), floor_wall(convective + "heat_flux = 30\n"),
        floor_wall(adiabatic) + two_bands,
        floor_wall(adiabatic) + "[media.air]\nabsorption = 1\nconductivity = 1\n"}) {
    const Case input = case_of(text);
    EXPECT_TRUE(has_temperatures(input)) << text;
    EXPECT_TRUE(iterates_temperatures(input)) << text;
    const TetrahedralMesh mesh = build_mesh(input);
    const Problem problem = build_problem(input, mesh);
    const HeatProblem heat = build_heat(input, mesh).value();
    int following = 0;
    for (std::size_t w = 0; w < mesh.wall_names().size(); ++w) {
      const bool follows = mesh.wall_names()[w] == "zmin";
      EXPECT_EQ(problem.walls()[w].emission_follows, follows) << text;
      ASSERT_EQ(heat.walls.at(w).has_value(), follows) << text;
      if (!follows) continue;
      ++following;
      EXPECT_EQ(problem.walls()[w].radiance[0], 0);
      EXPECT_NEAR(problem.walls()[w].diffuse[0], 0.3, 1e-15);
      EXPECT_EQ(heat.walls[w]->heat_flux, input.walls.at("zmin").heat_flux ? 30 : 0);
      EXPECT_EQ(heat.walls[w]->heat_transfer_coefficient, input.walls.at("zmin").convection ? 5 : 0);
      EXPECT_EQ(heat.walls[w]->ambient, input.walls.at("zmin").convection ? 290 : 0);
    }
    EXPECT_EQ(following, 1);
  }
  EXPECT_FALSE(iterates_temperatures(case_of(floor_wall(adiabatic))));
}

TEST(ReadHeatBalance, RefusesConvectionThatSaysTooLittleOrTooMuch) {
  const auto says = [](const std::string& wall, const char* what) {
    EXPECT_NE(faults_of(floor_wall(wall)).find(what), std::string::npos)
        << wall << faults_of(floor_wall(wall));
  };
  says("convection = { h = 5 }\n", "convection.ambient");
  says("convection = { ambient = 300 }\n", "convection.h");
  says("convection = { h = -1, ambient = 300 }\n", "at least 0");
  says("convection = { h = 1, ambient = 300 }\ntemperature = 400\n", "temperature is given too");
  says("convection = { h = 0, ambient = 300 }\nspecular = 1\n", "does not absorb");
  says("convection = { h = 1, ambient = 300 }\nheat_flux = 0\nrefractive_index = 1.5\n",
       "leave heat_flux out");
  says("convection = { h = 0, ambient = 300 }\nrefractive_index = 1.5\n", "give h above 0");
  says("convection = { h = 1, ambient = 300 }\n[solve]\nmethod = \"photons\"\n", "not by photons");
  says("convection = { h = 1, ambient = 300 }\nuncollided = true\n", "not as a light");
  says("convection = { h = 1, ambient = 300 }\nglazing = { transmittance = 0.9 }\n", "beside glazing");
}

TEST(ReadHeatBalance, StartsFromTheMeanEmissivePower) {
  const Case input =
      case_of(cube +
              "[media.air]\nabsorption = 1\nconductivity = 1\n[walls.zmin]\ntemperature = 300\n"
              "[walls.zmax]\ntemperature = 900\n");
  const TetrahedralMesh mesh = build_mesh(input);
  const HeatProblem heat = build_heat(input, mesh).value();
  EXPECT_NEAR(heat.start, std::pow((std::pow(300.0, 4) + std::pow(900.0, 4)) / 2, 0.25), 1e-9);
  for (std::size_t wall = 0; wall < mesh.wall_names().size(); ++wall)
    EXPECT_EQ(heat.wall_temperatures[wall].has_value(),
              mesh.wall_names()[wall] == "zmin" || mesh.wall_names()[wall] == "zmax");
}

TEST(ReadHeatBalance, RefusesWhatTheIterationCannot) {
  const std::string conducts = air("absorption = 1\nconductivity = 1\n");
  const auto says = [](const std::string& text, const char* what) {
    EXPECT_NE(faults_of(text).find(what), std::string::npos) << text << faults_of(text);
  };
  says(air("absorption = 1\nconductivity = 1\ntemperature = 300\n"), "temperature is given too");
  says(air("absorption = \"1 + wx\"\nconductivity = 1\n"), "depends on the direction");
  says(air("absorption = 1\nconductivity = -1\n"), "conductivity");
  says(conducts + "[solve]\nmethod = \"photons\"\n", "not by photons");
  says(conducts + "[directions]\nrotations = 3\n", "not on several rotations");
  std::string mirrored = conducts;
  const std::string all_walls = "[walls.\"*\"]\n";
  mirrored.insert(mirrored.find(all_walls) + all_walls.size(), "specular = 1\n");
  says(mirrored, "nothing takes its heat away");
  says(conducts + "[walls.zmin]\nrefractive_index = 1.5\n", "give them the same");
}

}  // namespace
}  // namespace etendue::read_heat_balance_test
