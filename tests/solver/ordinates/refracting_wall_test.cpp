// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Smooth walls with matter of another refractive index behind them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/measure/balance.h"
#include "solver/problem/mirror.h"
#include "tests/solver/ordinates/sample_problems.h"

namespace etendue {
namespace {

using std::numbers::pi;

std::vector<Wall> mirrors_with_floor(const TetrahedralMesh& mesh, const Wall& floor) {
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(name == "zmin" ? floor : uniform_wall(1, 0, 0, 1));
    walls.back().name = name;
  }
  return walls;
}

Wall floor_of_index(double index) {
  Wall floor = uniform_wall(1, 0, 0, 0);
  floor.refractive_index = index;
  return floor;
}

// In equilibrium the radiance is n^2 times that of empty space (Clausius 1864; Planck 1914, section 38).
TEST(RefractingWall, KeepsTheEquilibriumWithWhatIsBehind) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  for (const double index : {0.75, 1.5}) {
    Wall floor = floor_of_index(index);
    floor.radiance = {1};
    const Problem problem(mesh, Bands{}, {uniform_medium(1, 0.3, 1, 0.3 * index * index)},
                          mirrors_with_floor(mesh, floor));
    const Solution solution = solve(problem, directions_double_gauss(4), tight_options());
    ASSERT_TRUE(solution.converged());
    EXPECT_LT(largest_deviation(solution.fluence, 4 * pi * index * index), 1e-9) << index;
    // Of the light behind, pi (1 - r) comes in: as much as leaves.
    const auto at = std::ranges::find(mesh.wall_names(), "zmin") - mesh.wall_names().begin();
    const WallPower lit = wall_powers(problem, solution)[static_cast<std::size_t>(at)][0];
    EXPECT_NEAR(lit.outgoing, lit.incoming, 1e-8);
    EXPECT_NEAR(lit.emitted_exact, pi * (1 - mirrored_part_of_isotropic(floor_of_index(1 / index), 0)), 2e-3);
    EXPECT_NEAR(lit.emitted, lit.emitted_exact, 1e-9);
  }
}

TEST(RefractingWall, ClosesTheBalanceAndKeepsLightIn) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const Medium medium = uniform_medium(1, 0.1, 2, 1);
  double open = 0;
  for (const double index : {1.0, 1.5}) {
    const Problem problem(mesh, Bands{}, {medium}, mirrors_with_floor(mesh, floor_of_index(index)));
    const Solution solution = solve(problem, directions_double_gauss(4), tight_options());
    ASSERT_TRUE(solution.converged());
    const Balance balance = balances(problem, solution).front();
    EXPECT_LT(std::abs(balance.residual), 1e-9);
    if (index == 1)
      open = balance.outflow;
    else
      EXPECT_LT(balance.outflow, 0.9 * open);
  }
}

TEST(RefractingWall, ReflectsNothingElseAndHasNoFormula) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  Wall written = uniform_wall(1, 0, 0, 0);
  written.radiance_by_direction = {AngularFormula("1 + wz")};
  for (Wall floor : {uniform_wall(1, 0, 0.1, 0), uniform_wall(1, 0, 0, 0.1), written}) {
    floor.refractive_index = 1.5;
    EXPECT_THROW(Problem(mesh, Bands{}, {uniform_medium(1, 1, 0, 0)}, mirrors_with_floor(mesh, floor)),
                 InputError);
  }
}

}  // namespace
}  // namespace etendue
