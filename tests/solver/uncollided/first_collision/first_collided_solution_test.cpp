// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/uncollided/first_collision/first_collided_solution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/errors.h"
#include "solver/solution/balance.h"
#include "solver/uncollided/first_collision/solve_rotated.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::first_collided_solution_test {
namespace {

Light lamp(int bands) {
  PointLight point;
  point.position = {0.4, 0.55, 0.6};
  point.power.assign(static_cast<std::size_t>(bands), 1);
  return {"lamp", point, {}};
}

Problem lit(const TetrahedralMesh& mesh, const Medium& medium, const Wall& wall) {
  const int bands = static_cast<int>(medium.absorption.size());
  std::vector<Medium> media(mesh.region_names().size(), medium);
  std::vector<Wall> walls(mesh.wall_names().size(), wall);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    walls[i].name = mesh.wall_names()[i];
    walls[i].uncollided = Uncollided::no;
  }
  Bands named;
  for (int b = 1; b < bands; ++b) named.names.push_back("band " + std::to_string(b));
  return Problem(mesh, named, media, walls, AngularSpace::sphere, {lamp(bands)});
}

SolveOptions options_with_meter(const TetrahedralMesh& mesh) {
  SolveOptions options = tight_options();
  const Vec3 place(0.3, 0.7, 0.35);
  options.meters = {{CellLocator(mesh).find(place), Vec3(0, 0.6, 0.8)}};
  return options;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference = std::max(difference, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return size > 0 ? difference / size : difference;
}

void expect_the_same(const Solution& a, const Solution& b) {
  ASSERT_TRUE(a.converged());
  EXPECT_LT(largest_difference(a.fluence, b.fluence), 1e-10);
  EXPECT_LT(largest_difference(a.net_flux, b.net_flux), 1e-10);
  EXPECT_LT(largest_difference(a.irradiance, b.irradiance), 1e-10);
  EXPECT_LT(largest_difference(a.exitance, b.exitance), 1e-10);
  EXPECT_LT(largest_difference(a.meters, b.meters), 1e-10);
  EXPECT_LT(largest_difference(a.state.fluence, b.state.fluence), 1e-10);
  EXPECT_LT(largest_difference(a.state.moments, b.state.moments), 1e-10);
  EXPECT_LT(largest_difference(a.state.irradiance, b.state.irradiance), 1e-10);
}

/// Of a problem, the plain split answer and the one with the same set for what has collided once.
void expect_no_change_on_the_same_set(const Problem& problem, const SolveOptions& options) {
  const LightSetup lights(problem);
  const DirectionSet set = directions_ldfe_sq(1);
  expect_the_same(solve_split(lights, set, options, {}, &set), solve_split(lights, set, options));
}

TEST(FirstCollidedSolution, OnTheSameSetChangesNothing) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  expect_no_change_on_the_same_set(lit(mesh, uniform_medium(1, 0.3, 2, 0), uniform_wall(1, 0, 0.5, 0)),
                                   options_with_meter(mesh));
}

TEST(FirstCollidedSolution, OnTheSameSetChangesNothingWithMomentsBandsAndEmission) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  Medium haze = uniform_medium(3, 0.3, 2, 0.1, PhaseHenyeyGreenstein{0.5});
  haze.scattering[1] = Coefficient(0.5);
  haze.uncollided = Uncollided::no;
  expect_no_change_on_the_same_set(lit(mesh, haze, uniform_wall(3, 0.2, 0.4, 0)), options_with_meter(mesh));
}

TEST(FirstCollidedSolution, OnTheSameSetChangesNothingWhereThePeakIsLeftOut) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  Medium haze = uniform_medium(1, 0.3, 2, 0, PhaseHenyeyGreenstein{0.8});
  haze.choice = {{ScatteringBackend::moments, 3, ForwardPeak::delta_m}};
  expect_no_change_on_the_same_set(lit(mesh, haze, uniform_wall(1, 0, 0, 0)), options_with_meter(mesh));
}

// One mirror reflects within a sweep; of two that face each other one hands on to the next.
TEST(FirstCollidedSolution, OnTheSameSetChangesNothingWithMirrors) {
  const TetrahedralMesh mesh = cube_mesh(0.05);
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  for (std::size_t i = 0; i < walls.size(); ++i) walls[i].name = mesh.wall_names()[i];
  BeamLight beam;
  beam.direction = Vec3(0.3, -0.2, -1).normalized();
  beam.irradiance = {1};
  for (std::int32_t f = 0; f < mesh.boundary_face_count(); ++f) {
    const Vec3 normal = mesh.area_normal(FaceIndex(f)).normalized();
    const auto wall = static_cast<std::size_t>(mesh.wall(FaceIndex(f)));
    if (normal.z() > 0.9) beam.walls = {static_cast<int>(wall)};
    if (std::abs(normal.x()) > 0.9 || normal.y() < -0.9) walls[wall] = uniform_wall(1, 0, 0, 0.9);
    walls[wall].name = mesh.wall_names()[wall];
  }
  const Problem problem(mesh, {}, {uniform_medium(1, 0.2, 0.5, 0)}, walls, AngularSpace::sphere,
                        {{"sun", beam, {}}});
  SolveOptions options = tight_options();
  const LightSetup lights(problem);
  const DirectionSet set = directions_ldfe_sq(1);
  const Solution ladder = solve_split(lights, set, options, {}, &set);
  ASSERT_FALSE(ladder.state.mirrors.empty());
  expect_the_same(ladder, solve_split(lights, set, options));
}

TEST(FirstCollidedSolution, Balances) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  for (const PhaseFunction& phase :
       {PhaseFunction(PhaseIsotropic{}), PhaseFunction(PhaseHenyeyGreenstein{0.5})}) {
    const Problem problem = lit(mesh, uniform_medium(1, 0.3, 2, 0, phase), uniform_wall(1, 0, 0.5, 0));
    const LightSetup lights(problem);
    const DirectionSet finer = directions_ldfe_sq(2);
    const Solution solution = solve_split(lights, directions_ldfe_sq(1), tight_options(), {}, &finer);
    EXPECT_TRUE(solution.converged());
    EXPECT_NEAR(balances(problem, solution)[0].residual, solution.lights.balance[0].residual, 1e-9);
    EXPECT_NEAR(balances(problem, solution)[0].inflow, 1, 1e-12);
  }
}

// Where light scatters once in a hundred the rest is a hundredth of it, and so is what a coarse set does to
// the whole.
TEST(FirstCollidedSolution, BringsAThinMediumToTheAnswerOfTheFinerSet) {
  const TetrahedralMesh mesh = cube_mesh(0.005);
  const Problem problem = lit(mesh, uniform_medium(1, 0.01, 0.02, 0), uniform_wall(1, 0, 0, 0));
  const LightSetup lights(problem);
  const DirectionSet coarse = directions_level_symmetric(2), fine = directions_ldfe_sq(3);
  const auto collided = [&](const DirectionSet& set, const DirectionSet* first_collided) {
    Solution solution = solve_split(lights, set, tight_options(), {}, first_collided);
    return solution.state.fluence;
  };
  const std::vector<double> best = collided(fine, nullptr);
  const double plain = largest_difference(collided(coarse, nullptr), best);
  const double ladder = largest_difference(collided(coarse, &fine), best);
  EXPECT_GT(plain, 0.05);
  EXPECT_LT(ladder, 0.02 * plain);
}

TEST(FirstCollidedSolution, TurnsWithTheSetsThatAMeanIsTakenOver) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = lit(mesh, uniform_medium(1, 0.3, 2, 0), uniform_wall(1, 0, 0.5, 0));
  const LightSetup lights(problem);
  const std::vector<DirectionSet> sets = rotated_copies(directions_ldfe_sq(1), 2, 3),
                                  finer = rotated_copies(directions_ldfe_sq(2), 2, 3);
  const Solution mean = solve_rotated(lights, sets, tight_options(), {}, finer);
  const Solution a = solve_split(lights, sets[0], tight_options(), {}, &finer[0]);
  const Solution b = solve_split(lights, sets[1], tight_options(), {}, &finer[1]);
  for (std::size_t i = 0; i < mean.fluence.size(); ++i)
    EXPECT_NEAR(mean.fluence[i], (a.fluence[i] + b.fluence[i]) / 2, 1e-9);
  EXPECT_NEAR(balances(problem, mean)[0].residual, mean.lights.balance[0].residual, 1e-9);
}

TEST(FirstCollidedSolution, GoesOnFromItsOwnState) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = lit(mesh, uniform_medium(1, 0.1, 5, 0), uniform_wall(1, 0, 0.5, 0));
  const LightSetup lights(problem);
  const DirectionSet set = directions_ldfe_sq(1), finer = directions_ldfe_sq(2);
  SolveOptions options;
  options.tolerance = 1e-8;
  const Solution first = solve_split(lights, set, options, {}, &finer);
  options.initial = &first.state;
  const Solution again = solve_split(lights, set, options, {}, &finer);
  EXPECT_LE(again.convergence[0].sweeps, 4);
  EXPECT_LT(largest_difference(again.fluence, first.fluence), 1e-7);
}

TEST(FirstCollidedSolution, RefusesMatricesAndSetsThatAreTooCoarse) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const auto refusal = [&](const PhaseFunction& phase, ScatteringBackend backend, const DirectionSet& finer) {
    Medium haze = uniform_medium(1, 0.3, 2, 0, phase);
    haze.choice = {{backend, -1, ForwardPeak::automatic}};
    const Problem problem = lit(mesh, haze, uniform_wall(1, 0, 0, 0));
    const LightSetup lights(problem);
    try {
      solve_split(lights, directions_ldfe_sq(1), tight_options(), {}, &finer);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal(PhaseHenyeyGreenstein{0.5}, ScatteringBackend::dense, directions_ldfe_sq(2))
                .find("through a matrix"),
            std::string::npos);
  EXPECT_NE(refusal(PhaseHenyeyGreenstein{0.5}, ScatteringBackend::moments, directions_level_symmetric(2))
                .find("use a finer set"),
            std::string::npos);
}

}  // namespace
}  // namespace etendue::first_collided_solution_test
