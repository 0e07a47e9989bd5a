// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Emission and wall radiance that depend on the direction.
#include "solver/transport/source/directional_emission.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/solution/balance.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::directional_emission_test {
namespace {

using std::numbers::pi;

std::vector<std::optional<AngularFormula>> formula(const std::string& text) { return {AngularFormula(text)}; }

Medium glowing(double absorption, double scattering, const std::string& emission) {
  Medium medium = uniform_medium(1, absorption, scattering, 0, PhaseHenyeyGreenstein{0.5});
  medium.emission_by_direction = formula(emission);
  return medium;
}

// u = 1 + w.s in all places: emission sigma_a u, and u from the walls.
TEST(DirectionalEmission, KeepsARadianceThatDependsOnTheDirectionAlone) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const std::string radiance = "1 + 0.5*wx - 0.3*wz";
  Wall wall = uniform_wall(1, 0, 0, 0);
  wall.radiance_by_direction = formula(radiance);
  const Problem problem = uniform_problem(mesh, glowing(0.7, 0, "0.7*(" + radiance + ")"), wall);
  const Solution solution = solve(problem, directions_ldfe_sq(1), tight_options());
  for (std::int32_t c = 0; c < mesh.cell_count(); ++c)
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t node = static_cast<std::size_t>(c) * 4 + i;
      EXPECT_NEAR(solution.fluence[node], 4 * pi, 1e-11);
      EXPECT_NEAR(solution.net_flux[node * 3], 4 * pi / 3 * 0.5, 1e-11);
      EXPECT_NEAR(solution.net_flux[node * 3 + 2], -4 * pi / 3 * 0.3, 1e-11);
    }
}

TEST(DirectionalEmission, OfAFormulaWithoutDirectionsIsThatOfTheNumber) {
  const TetrahedralMesh mesh = cube_mesh(5e-2);
  Wall plain = uniform_wall(1, 1.5, 0.4, 0), written = uniform_wall(1, 0, 0.4, 0);
  written.radiance_by_direction = formula("1.5");
  const Solution a = solve(uniform_problem(mesh, uniform_medium(1, 0.2, 1, 0.3), plain),
                           directions_product(4), tight_options());
  Medium medium = uniform_medium(1, 0.2, 1, 0);
  medium.emission_by_direction = formula("0.3");
  const Solution b = solve(uniform_problem(mesh, medium, written), directions_product(4), tight_options());
  for (std::size_t i = 0; i < a.fluence.size(); ++i) EXPECT_NEAR(a.fluence[i], b.fluence[i], 1e-9);
}

TEST(DirectionalEmission, ClosesTheBalanceWithScatteringAndReflection) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  Wall wall = uniform_wall(1, 0.1, 0.5, 0);
  wall.radiance_by_direction = formula("max(0, wz)^2*(1 + x)");
  const Problem problem = uniform_problem(mesh, glowing(0.3, 1, "(1 + wx)*exp(-y)"), wall);
  const Solution solution = solve(problem, directions_ldfe_sq(1), tight_options());
  ASSERT_TRUE(solution.converged());
  const Balance balance = balances(problem, solution).front();
  EXPECT_LT(std::abs(balance.residual), 1e-10);
  // The integral of 1 + wx over all directions is 4 pi; linear between vertices exp(-y) is a little larger.
  EXPECT_NEAR(balance.emitted, 4 * pi * (1 - std::exp(-1)), 0.02 * balance.emitted);
}

TEST(DirectionalEmission, ThatIsNegativeNamesTheMediumThePointAndTheDirection) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  const Problem problem = uniform_problem(mesh, glowing(1, 0, "wz + 0.5"), uniform_wall(1, 0, 0, 0));
  try {
    solve(problem, directions_product(2), SolveOptions{});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("media.domain.emission = -0.07735"), std::string::npos) << text;
    EXPECT_NE(text.find("in the direction ("), std::string::npos) << text;
  }
}

TEST(DirectionalEmission, OfAWallMayBeNegativeWhereLightDoesNotEnter) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0, 0, 0));
    walls.back().name = name;
    if (name == "zmin") walls.back().radiance_by_direction = formula("wz");
  }
  const Problem below(mesh, Bands{}, {uniform_medium(1, 1, 0, 0)}, walls);
  const DirectionSet directions = directions_double_gauss(4);
  const Solution solution = solve(below, directions, tight_options());
  // The integral of wz over the half range is 2 pi/3.
  for (std::size_t w = 0; w < walls.size(); ++w)
    EXPECT_NEAR(wall_powers(below, solution)[w][0].emitted, walls[w].name == "zmin" ? 2 * pi / 3 : 0, 1e-12);
  walls[0].radiance_by_direction = formula("-1");
  const Problem dark(mesh, Bands{}, {uniform_medium(1, 1, 0, 0)}, walls);
  EXPECT_THROW(solve(dark, directions, SolveOptions{}), InputError);
}

}  // namespace
}  // namespace etendue::directional_emission_test
