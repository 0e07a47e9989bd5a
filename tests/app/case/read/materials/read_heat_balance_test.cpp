// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/case/read/materials/read_heat_balance.h"

#include <gtest/gtest.h>

#include <numbers>

#include "app/case/build/build.h"
#include "app/case/temperatures.h"
#include "tests/app/case/case_text.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"

namespace etendue {
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
  EXPECT_NE(faults_of(air("absorption = [1, 1]\nheat_source = 1\n") + two_bands).find("one gray band"),
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

}  // namespace
}  // namespace etendue
