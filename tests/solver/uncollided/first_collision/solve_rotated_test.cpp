// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/first_collision/solve_rotated.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/errors.h"
#include "solver/solution/balance.h"
#include "solver/solution/solve_observer.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::solve_rotated_test {
namespace {

/// Smoke between dark walls, of which the first may shine.
Problem smoky_room(const TetrahedralMesh& mesh, double scattering, double radiance,
                   std::vector<Light> lights = {}) {
  std::vector<Medium> media(mesh.region_names().size(), uniform_medium(1, 0.1, scattering, 0));
  std::vector<Wall> walls;
  for (std::size_t w = 0; w < mesh.wall_names().size(); ++w) {
    walls.push_back(uniform_wall(1, w == 0 ? radiance : 0, 0.2, 0));
    walls.back().name = mesh.wall_names()[w];
    walls.back().uncollided = Uncollided::no;
  }
  return Problem(mesh, {}, media, walls, AngularSpace::sphere, std::move(lights));
}

/// Light with rays in it.
Problem lit_from_one_side(const TetrahedralMesh& mesh, double scattering = 0.5) {
  return smoky_room(mesh, scattering, 1);
}

std::vector<double> cell_means(const Solution& solution) {
  std::vector<double> means;
  for (std::size_t at = 0; at < solution.fluence.size(); at += 4)
    means.push_back((solution.fluence[at] + solution.fluence[at + 1] + solution.fluence[at + 2] +
                     solution.fluence[at + 3]) /
                    4);
  return means;
}

struct Room {
  TetrahedralMesh mesh = cube_mesh(2e-2);
  Problem problem = lit_from_one_side(mesh);
  LightSetup lights{problem};
  DirectionSet set = directions_ldfe_sq(1);
  SolveOptions options = tight_options();
};

TEST(SolveRotated, WithOneSetIsTheSolutionOnIt) {
  const Room room;
  const Solution mean = solve_rotated(room.lights, {room.set}, room.options);
  const Solution one = solve_split(room.lights, room.set, room.options);
  EXPECT_EQ(mean.fluence, one.fluence);
  EXPECT_EQ(mean.notes, one.notes);
  EXPECT_TRUE(mean.direction_error.empty());
}

TEST(SolveRotated, IsTheMeanAndItsStandardError) {
  const Room room;
  const std::vector<DirectionSet> sets = rotated_copies(room.set, 3, 7);
  const Solution mean = solve_rotated(room.lights, sets, room.options);
  ASSERT_TRUE(mean.converged());
  std::vector<Solution> each;
  for (const DirectionSet& set : sets) each.push_back(solve_split(room.lights, set, room.options));
  for (std::size_t i = 0; i < mean.fluence.size(); ++i)
    EXPECT_NEAR(mean.fluence[i], (each[0].fluence[i] + each[1].fluence[i] + each[2].fluence[i]) / 3, 1e-9);
  for (std::size_t i = 0; i < mean.irradiance.size(); ++i)
    EXPECT_NEAR(mean.irradiance[i],
                (each[0].irradiance[i] + each[1].irradiance[i] + each[2].irradiance[i]) / 3, 1e-9);
  const std::vector<double> a = cell_means(each[0]), b = cell_means(each[1]), c = cell_means(each[2]);
  ASSERT_EQ(mean.direction_error.size(), a.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double middle = (a[i] + b[i] + c[i]) / 3;
    const double squares =
        std::pow(a[i] - middle, 2) + std::pow(b[i] - middle, 2) + std::pow(c[i] - middle, 2);
    EXPECT_NEAR(mean.direction_error[i], std::sqrt(squares / 6), 1e-9);
    largest = std::max(largest, mean.direction_error[i]);
  }
  EXPECT_GT(largest, 1e-3);
  EXPECT_LT(std::abs(balances(room.problem, mean)[0].residual), 1e-9);
  EXPECT_NE(mean.notes.front().find("mean of 3 rotated sets"), std::string::npos);
}

TEST(SolveRotated, StartsFromTheRotationBefore) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const Problem problem = lit_from_one_side(mesh, 20);
  const LightSetup lights(problem);
  SolveOptions options;
  options.tolerance = 1e-4;
  const std::vector<DirectionSet> sets = rotated_copies(directions_ldfe_sq(1), 3, 1);
  const int warm = solve_rotated(lights, sets, options).convergence[0].sweeps;
  int cold = 0;
  for (const DirectionSet& set : sets) cold += solve_split(lights, set, options).convergence[0].sweeps;
  EXPECT_LE(warm, cold - 2);
}

TEST(SolveRotated, ErrorBarsHoldTheLimitOfManyDirections) {
  const Room room;
  SolveOptions options;
  const Solution mean = solve_rotated(room.lights, rotated_copies(room.set, 10, 3), options);
  const std::vector<double> limit = cell_means(solve_split(room.lights, directions_ldfe_sq(3), options));
  const std::vector<double> means = cell_means(mean);
  std::size_t within = 0;
  for (std::size_t i = 0; i < means.size(); ++i)
    within += std::abs(means[i] - limit[i]) < 3 * mean.direction_error[i] ? 1 : 0;
  // Of Student's distribution of 9 degrees of freedom 98.5 % lie within three.
  EXPECT_GT(static_cast<double>(within), 0.95 * static_cast<double>(means.size()));
}

TEST(SolveRotated, HasNoSpreadInAFurnace) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.5, 1, 0.5), uniform_wall(1, 0.5, 0.5, 0));
  const LightSetup lights(problem);
  const Solution mean = solve_rotated(lights, rotated_copies(directions_ldfe_sq(1), 3, 1), tight_options());
  for (const double error : mean.direction_error) EXPECT_LT(error, 1e-8);
  EXPECT_LT(relative_direction_error(mesh, mean), 1e-9);
}

TEST(SolveRotated, KeepsWhatIsWholeWhenItIsStopped) {
  const Room room;
  const std::vector<DirectionSet> sets = rotated_copies(room.set, 4, 1);
  int sweeps_of_one = 0;
  solve_split(room.lights, room.set, room.options, [&](const SweepProgress& progress) {
    sweeps_of_one = progress.sweep;
    return SolveControl::proceed;
  });
  const Solution stopped = solve_rotated(room.lights, sets, room.options, [&](const SweepProgress& progress) {
    return progress.sweep > sweeps_of_one + 2 ? SolveControl::stop : SolveControl::proceed;
  });
  EXPECT_TRUE(stopped.interrupted);
  EXPECT_EQ(stopped.fluence, solve_split(room.lights, room.set, room.options).fluence);
  EXPECT_TRUE(stopped.direction_error.empty());
}

TEST(SolveRotated, SharesTheUncollidedLight) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  PointLight lamp;
  lamp.position = {0.4, 0.55, 0.6};
  lamp.power = {1};
  const Problem problem = smoky_room(mesh, 1, 0, {{"lamp", lamp, {}}});
  const LightSetup lights(problem);
  const Solution mean = solve_rotated(lights, rotated_copies(directions_ldfe_sq(1), 2, 1), tight_options());
  const Solution one = solve_split(lights, directions_ldfe_sq(1), tight_options());
  EXPECT_EQ(mean.lights.fluence, one.lights.fluence);
  EXPECT_EQ(mean.lights.balance[0].sent, one.lights.balance[0].sent);
  EXPECT_NEAR(balances(problem, mean)[0].inflow, 1, 1e-12);
  EXPECT_LT(std::abs(balances(problem, mean)[0].residual - one.lights.balance[0].residual), 1e-9);
}

}  // namespace
}  // namespace etendue::solve_rotated_test
