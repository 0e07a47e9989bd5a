// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Smooth walls with a medium of another refractive index behind them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/angular/refraction/refraction_weights.h"
#include "solver/problem/mirror.h"
#include "solver/solution/balance.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::refracting_wall_test {
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
    EXPECT_NEAR(lit.emitted_exact, pi * (1 - mirrored_part_of_isotropic(floor_of_index(1 / index), 0)), 1e-8);
    EXPECT_NEAR(lit.emitted, lit.emitted_exact, 1e-9);
  }
}

/// A cube of n^2 in equilibrium with the light behind its walls, all of which refract.
void expect_equilibrium(const TetrahedralMesh& mesh, const DirectionSet& set, double index) {
  Wall wall = floor_of_index(index);
  wall.radiance = {1};
  const Problem problem(mesh, Bands{}, {uniform_medium(1, 0.3, 1, 0.3 * index * index)},
                        std::vector<Wall>(mesh.wall_names().size(), wall));
  const DirectionSet fitted = fitted_to_refraction(set, smooth_planes(mesh, problem.walls()));
  const Solution solution = solve(problem, fitted, tight_options());
  ASSERT_TRUE(solution.converged());
  EXPECT_LT(largest_deviation(solution.fluence, 4 * pi * index * index), 1e-9) << set.name() << " " << index;
  EXPECT_LT(std::abs(balances(problem, solution)[0].residual), 1e-9) << set.name() << " " << index;
}

TEST(RefractingWall, KeepsTheEquilibriumOnEverySet) {
  const TetrahedralMesh mesh = cube_mesh(0.1);
  for (const DirectionSet& set :
       {directions_product(8), directions_triangular(8), directions_double_gauss(4),
        directions_level_symmetric(8), directions_thurgood(3), directions_ldfe_sq(1)})
    for (const double index : {0.75, 1.33, 2.0}) expect_equilibrium(mesh, set, index);
}

// Sides across the diagonals of x and y, which every set below has mirror images at.
TEST(RefractingWall, KeepsTheEquilibriumInAnObliqueCube) {
  const double s = std::sqrt(0.5);
  const TetrahedralMesh mesh = moved_mesh(
      cube_mesh(0.1), [s](const Vec3& p) { return Vec3(s * (p.x() - p.y()), s * (p.x() + p.y()), p.z()); });
  for (const DirectionSet& set :
       {directions_product(8), directions_level_symmetric(8), directions_ldfe_sq(2)})
    expect_equilibrium(mesh, set, 1.5);
}

// A slab that absorbs behind two surfaces, in diffuse light: the sum over all internal reflections,
// 2 n^2 (1 - R)(1 - e)/(1 - R e) mu dmu with e = exp(-tau/mu), R of Fresnel.
TEST(RefractingWall, FindsWhatAnAbsorbingSlabTakesOfDiffuseLight) {
  const TetrahedralMesh mesh = cube_mesh(3e-3);
  const double index = 1.5, thickness = 1;
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(name.front() == 'z' ? floor_of_index(index) : uniform_wall(1, 0, 0, 1));
    if (name == "zmin") walls.back().radiance = {1 / pi};
  }
  const Problem problem(mesh, Bands{}, {uniform_medium(1, thickness, 0, 0)}, walls);
  const DirectionSet set = fitted_to_refraction(directions_ldfe_sq(2), smooth_planes(mesh, walls));
  const Solution solution = solve(problem, set, tight_options());
  double absorbed = 0;
  constexpr int steps = 10000;
  const double critical = critical_cosine(index);
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) / steps, mu = critical + (1 - critical) * t * t;
    const double e = std::exp(-thickness / mu), r = fresnel_reflectance(mu, index);
    absorbed += 4 * t * (1 - critical) / steps * index * index * mu * (1 - r) * (1 - e) / (1 - r * e);
  }
  const Balance balance = balances(problem, solution).front();
  EXPECT_NEAR(balance.absorbed / absorbed, 1, 5e-3);
  EXPECT_LT(std::abs(balance.residual), 1e-9);
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
}  // namespace etendue::refracting_wall_test
