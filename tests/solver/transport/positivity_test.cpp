// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Solutions whose values are kept positive.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/solution/balance.h"
#include "solver/transport/solve/solve.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::positivity_test {
namespace {

constexpr double four_pi = 4 * std::numbers::pi;

double smallest(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

SolveOptions options_of(Positivity positivity, double tolerance = 1e-11) {
  SolveOptions options = tight_options();
  options.positivity = positivity;
  options.tolerance = tolerance;
  options.max_sweeps = 2000;
  for (int m = 0; m < 24; ++m) options.keep_ordinates.push_back(m);
  return options;
}

/// A ball in a room that one wall lights: its shadow has a sharp edge in every direction.
Problem ball_in_a_room(const TetrahedralMesh& mesh, double absorption, double scattering, double around,
                       double diffuse) {
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names()) {
    media.push_back(name == "ball" ? uniform_medium(2, absorption, scattering, 0)
                                   : uniform_medium(2, 0.01, around, 0));
    media.back().name = name;
  }
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(name == "zmax"   ? uniform_wall(2, 1, 0, 0)
                    : name == "xmin" ? uniform_wall(2, 0, 0, 0.8)
                                     : uniform_wall(2, 0, diffuse, 0));
    walls.back().name = name;
  }
  Bands bands;
  bands.names = {"a", "b"};
  return Problem(mesh, bands, media, walls);
}

void expect_positive(const Problem& problem, const Solution& solution) {
  ASSERT_TRUE(solution.converged());
  EXPECT_GE(smallest(solution.fluence), 0);
  EXPECT_GE(smallest(solution.irradiance), 0);
  for (const OrdinateRadiance& kept : solution.radiance) EXPECT_GE(smallest(kept.values), 0);
  for (const Balance& balance : balances(problem, solution)) EXPECT_LT(std::abs(balance.residual), 1e-9);
  for (const NegativeCensus& census : solution.negative) EXPECT_EQ(census.count, 0);
  std::int64_t cells = 0;
  for (const OrdinateFixup& fixup : solution.fixups) {
    cells += fixup.cells;
    EXPECT_EQ(fixup.failed, 0);
    EXPECT_EQ(fixup.cells > 0, fixup.smallest < 0);
    EXPECT_EQ(fixup.cells > 0, fixup.moved > 0);
  }
  EXPECT_GT(cells, 0);
}

TEST(Positivity, HoldsInAThickAbsorberThatIsLitAllAround) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const DirectionSet directions = directions_triangular(4);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 100, 0, 0), uniform_wall(1, 1, 0, 0));
  EXPECT_LT(smallest(solve(problem, directions, tight_options()).fluence), -0.4);
  for (const Positivity positivity : {Positivity::rescale, Positivity::quadratic})
    expect_positive(problem, solve(problem, directions, options_of(positivity)));
}

TEST(Positivity, HoldsAtTheEdgeOfAShadowWithMirrorsWallsAndScattering) {
  const TetrahedralMesh mesh = cube_with_ball(2e-2);
  const DirectionSet directions = directions_triangular(4);
  for (const double scattering : {0.0, 1.0}) {
    const Problem problem = ball_in_a_room(mesh, 50, 10 * scattering, scattering, 0.5 * scattering);
    for (const Positivity positivity : {Positivity::rescale, Positivity::quadratic})
      expect_positive(problem, solve(problem, directions, options_of(positivity)));
  }
}

TEST(Positivity, LeavesASolutionWithoutNegativeValuesAlone) {
  const TetrahedralMesh mesh = cube_with_ball(3e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.5, 0.8, 0.5, PhaseHenyeyGreenstein{0.3}),
                                          uniform_wall(1, 0.6, 0.4, 0));
  const Solution solution = solve(problem, directions_ldfe_sq(1), options_of(Positivity::quadratic));
  ASSERT_TRUE(solution.converged());
  for (const double value : solution.fluence) EXPECT_NEAR(value, four_pi, 1e-9);
  for (const OrdinateFixup& fixup : solution.fixups) EXPECT_EQ(fixup.cells, 0);
}

TEST(Positivity, GivesTheSameBitsForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = cube_with_ball(2e-3);
  const Problem problem = ball_in_a_room(mesh, 50, 10, 1, 0.5);
  SolveOptions options = options_of(Positivity::quadratic, 1e-3);
  const auto with = [&](int threads) {
    options.threads = threads;
    return solve(problem, directions_triangular(4), options);
  };
  const Solution one = with(1);
  for (const int threads : {2, 3}) {
    const Solution many = with(threads);
    EXPECT_EQ(many.fluence, one.fluence);
    EXPECT_EQ(many.irradiance, one.irradiance);
    for (std::size_t i = 0; i < one.fixups.size(); ++i) EXPECT_EQ(many.fixups[i].moved, one.fixups[i].moved);
  }
}

TEST(Positivity, EstimatedErrorBoundsTheTrueError) {
  const TetrahedralMesh mesh = cube_with_ball(2e-2);
  const DirectionSet directions = directions_triangular(4);
  for (const double absorption : {50.0, 5.0})
    for (const Acceleration acceleration : {Acceleration::none, Acceleration::diffusion}) {
      const Problem problem = ball_in_a_room(mesh, absorption, 30, 2, 0.8);
      SolveOptions options = options_of(Positivity::quadratic, 1e-12);
      options.acceleration = acceleration;
      const Solution exact = solve(problem, directions, options);
      ASSERT_TRUE(exact.converged());
      for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
        options.tolerance = tolerance;
        const Solution rough = solve(problem, directions, options);
        ASSERT_TRUE(rough.converged());
        for (std::size_t band = 0; band < 2; ++band)
          EXPECT_LT(difference(rough, exact, 2, band), tolerance) << "absorption " << absorption;
      }
    }
}

TEST(Positivity, TakesFewSweepsInThickBrightMedia) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  for (const double scattering : {10.0, 100.0, 500.0})
    for (const Positivity positivity : {Positivity::rescale, Positivity::quadratic}) {
      const Problem problem =
          uniform_problem(mesh, uniform_medium(1, 0, scattering, 0), uniform_wall(1, 0.5, 0, 0));
      SolveOptions options = options_of(positivity, 1e-6);
      options.acceleration = Acceleration::diffusion;
      const Solution solution = solve(problem, directions_triangular(4), options);
      ASSERT_TRUE(solution.converged());
      EXPECT_LE(solution.convergence[0].sweeps, 60) << "scattering " << scattering;
      // Full of isotropic light of radiance 1/2.
      for (const double value : solution.fluence) EXPECT_NEAR(value, 0.5 * four_pi, 1e-4);
    }
}

TEST(Positivity, AcceleratedGivesTheSameAnswer) {
  const TetrahedralMesh mesh = cube_with_ball(1e-2);
  const Problem problem = ball_in_a_room(mesh, 5, 30, 2, 0.8);
  std::vector<Solution> solutions;
  for (const Acceleration acceleration : {Acceleration::none, Acceleration::diffusion}) {
    SolveOptions options = options_of(Positivity::rescale);
    options.acceleration = acceleration;
    solutions.push_back(solve(problem, directions_triangular(4), options));
    expect_positive(problem, solutions.back());
  }
  for (std::size_t i = 0; i < solutions[0].fluence.size(); ++i)
    EXPECT_NEAR(solutions[0].fluence[i], solutions[1].fluence[i], 1e-8);
}

TEST(Positivity, GoesOnFromAPositiveState) {
  const TetrahedralMesh mesh = cube_with_ball(1e-2);
  const Problem problem = ball_in_a_room(mesh, 5, 30, 2, 0.8);
  SolveOptions options = options_of(Positivity::rescale, 1e-8);
  const Solution whole = solve(problem, directions_triangular(4), options);
  options.initial = &whole.state;
  const Solution again = solve(problem, directions_triangular(4), options);
  ASSERT_TRUE(again.converged());
  EXPECT_LE(again.convergence[0].sweeps, 5);
  for (std::size_t band = 0; band < 2; ++band) EXPECT_LT(difference(again, whole, 2, band), 2e-8);
}

TEST(Positivity, IsNotConvergedWhereNoSweepsAreLeftForIt) {
  const TetrahedralMesh mesh = cube_with_ball(2e-2);
  const Problem problem = ball_in_a_room(mesh, 50, 10, 1, 0.5);
  const DirectionSet directions = directions_triangular(4);
  SolveOptions options = options_of(Positivity::none, 1e-6);
  const Solution linear = solve(problem, directions, options);
  ASSERT_TRUE(linear.converged());
  options.max_sweeps = std::max(linear.convergence[0].sweeps, linear.convergence[1].sweeps);
  ASSERT_TRUE(solve(problem, directions, options).converged());
  options.positivity = Positivity::rescale;
  const Solution solution = solve(problem, directions, options);
  EXPECT_FALSE(solution.converged());
  EXPECT_TRUE(std::any_of(solution.notes.begin(), solution.notes.end(), [](const std::string& note) {
    return note.find("no sweeps are left") != std::string::npos;
  }));
}

}  // namespace
}  // namespace etendue::positivity_test
