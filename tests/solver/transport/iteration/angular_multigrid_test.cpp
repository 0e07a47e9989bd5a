// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Corrections of GMRES on fewer directions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "solver/materials/surfaces/phong.h"
#include "solver/solution/balance.h"
#include "solver/transport/iteration/coarse_correction.h"
#include "solver/transport/solve/angular_multigrid.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::angular_multigrid_test {
namespace {

/// Values between 0 and 2.
void fill(std::span<double> values, int seed) {
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = 1 + std::sin(static_cast<double>((i + static_cast<std::size_t>(seed)) * i % 1013));
}

bool has_note(const Solution& solution, const std::string& part) {
  return std::ranges::any_of(solution.notes,
                             [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

TEST(CoarseDirections, SweepAsTheirOwnSetDoes) {
  const TetrahedralMesh mesh = cube_with_ball(5e-3);
  const Problem problem = uniform_problem(mesh, uniform_medium(3, 1, 3.8, 0.7), uniform_wall(3, 0.2, 0.4, 0));
  const DirectionSet many = directions_ldfe_sq(2), few = directions_product(4);
  const std::vector<double> extinction = extinction_of(problem);
  TransportSweep fine(problem, many, extinction, tight_options(Lumping::automatic));
  TransportSweep own(problem, few, extinction, tight_options(Lumping::automatic));
  CoarseDirections coarse(fine, few);
  TransportState last(fine.layout()), next(fine.layout()), own_last(own.layout()), own_next(own.layout());
  for (TransportState* state : {&last, &own_last}) {
    fill(state->fluence(), 1);
    fill(state->irradiance(), 2);
  }
  coarse.apply_linear(last, next, std::vector<char>(3, 1));
  own.apply_linear(own_last, own_next);
  constexpr double rounding = 5 * std::numeric_limits<float>::epsilon();
  EXPECT_LT(relative_difference(next.fluence(), own_next.fluence()), rounding);
  EXPECT_LT(relative_difference(next.irradiance(), own_next.irradiance()), rounding);
  EXPECT_EQ(coarse.sweeps(), 1);
}

// Of moments of degree 7 the set of 32 directions resolves the first three degrees.
TEST(CoarseDirections, GiveNothingWhereTheyResolveNothing) {
  const TetrahedralMesh mesh = cube_with_ball(5e-3);
  Medium medium = uniform_medium(1, 1, 3.8, 0.7, PhaseHenyeyGreenstein{0.7});
  medium.choice.assign(1, {ScatteringBackend::moments, 7});
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(1, 0.2, 0.4, 0));
  const DirectionSet many = directions_ldfe_sq(2);
  const std::vector<double> extinction = extinction_of(problem);
  TransportSweep fine(problem, many, extinction, tight_options(Lumping::automatic));
  CoarseDirections coarse(fine, directions_product(4));
  TransportState last(fine.layout()), next(fine.layout());
  fill(last.values(), 1);
  fill(next.values(), 2);
  coarse.apply_linear(last, next, std::vector<char>(1, 1));
  const std::size_t cell = next.moments().size() / static_cast<std::size_t>(mesh.cell_count());
  const std::size_t moment = cell / 64;
  for (std::size_t i = 0; i < next.moments().size(); ++i)
    EXPECT_EQ(next.moments()[i] != 0, i % cell / moment < 16) << i;
}

struct Sample {
  const char* name;
  Problem problem;
  DirectionSet directions;
};

std::vector<Sample> varied_problems(const TetrahedralMesh& mesh) {
  Medium forward = uniform_medium(3, 0.1, 0, 0.2, PhaseHenyeyGreenstein{0.7});
  forward.scattering = {Coefficient(0.5), Coefficient(3.0), Coefficient(8.0)};
  forward.choice.assign(3, {ScatteringBackend::moments, 7});
  std::vector<Sample> problems;
  problems.push_back({"moments, bands apart", uniform_problem(mesh, forward, uniform_wall(3, 0.3, 0.5, 0)),
                      directions_ldfe_sq(3)});
  problems.push_back({"void", uniform_problem(mesh, uniform_medium(2, 0, 0, 0), uniform_wall(2, 1, 0.7, 0)),
                      directions_thurgood(10)});
  problems.push_back({"bright",
                      uniform_problem(mesh, uniform_medium(1, 0.1, 5, 1), uniform_wall(1, 0.1, 0.8, 0)),
                      directions_triangular(28)});
  return problems;
}

TEST(AngularMultigrid, GivesTheSameSolutionInFewerSweeps) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  for (const Sample& sample : varied_problems(mesh))
    for (const Acceleration acceleration : {Acceleration::none, Acceleration::diffusion})
      for (const double tolerance : {1e-4, 1e-10}) {
        SolveOptions options = tight_options(Lumping::automatic);
        options.acceleration = acceleration;
        options.tolerance = 1e-12;
        options.angular_multigrid = AngularMultigrid::none;
        const Solution exact = solve(sample.problem, sample.directions, options);
        options.tolerance = tolerance;
        const Solution plain = solve(sample.problem, sample.directions, options);
        options.angular_multigrid = AngularMultigrid::automatic;
        const Solution corrected = solve(sample.problem, sample.directions, options);
        SCOPED_TRACE(sample.name);
        ASSERT_TRUE(exact.converged());
        ASSERT_TRUE(corrected.converged());
        EXPECT_TRUE(has_note(corrected, "corrected on ")) << sample.name;
        EXPECT_FALSE(has_note(plain, "corrected on ")) << sample.name;
        const int bands = sample.problem.band_count();
        for (int band = 0; band < bands; ++band)
          EXPECT_LT(
              difference(corrected, exact, static_cast<std::size_t>(bands), static_cast<std::size_t>(band)),
              2 * tolerance);
        // Of few sweeps none can be saved.
        EXPECT_LT(corrected.convergence[0].sweeps, std::max(6, plain.convergence[0].sweeps));
        for (const Balance& balance : balances(sample.problem, corrected))
          EXPECT_LT(std::abs(balance.residual), 10 * tolerance);
      }
}

TEST(AngularMultigrid, TakesAtMostASixthOfTheDirections) {
  const TetrahedralMesh mesh = cube_mesh(5e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.1, 1, 1), uniform_wall(1, 0.3, 0.4, 0));
  EXPECT_FALSE(coarser_directions(problem, directions_ldfe_sq(2), {}));
  EXPECT_EQ(coarser_directions(problem, directions_ldfe_sq(3), {})->count(), 128);
  EXPECT_FALSE(coarser_directions(problem, directions_flatland(1024), {}));
  SolveOptions without, source_iteration;
  without.angular_multigrid = AngularMultigrid::none;
  source_iteration.method = Method::source_iteration;
  EXPECT_FALSE(coarser_directions(problem, directions_ldfe_sq(3), without));
  EXPECT_FALSE(coarser_directions(problem, directions_ldfe_sq(3), source_iteration));
}

TEST(AngularMultigrid, LeavesAloneWhatItCannotCorrect) {
  const TetrahedralMesh mesh = cube_mesh(5e-2);
  Medium matrix = uniform_medium(1, 0.2, 2, 1, PhaseHenyeyGreenstein{0.8});
  matrix.choice.assign(1, {ScatteringBackend::dense});
  Wall polished = uniform_wall(1, 0.3, 0.1, 0);
  polished.glossy = {std::make_shared<Phong>(0.7, 20)};
  const Medium thin = uniform_medium(1, 0.1, 1, 1), thick = uniform_medium(1, 1e-3, 100, 1);
  for (const Problem& problem :
       {uniform_problem(mesh, matrix, uniform_wall(1, 0.3, 0.4, 0)),
        uniform_problem(mesh, thin, uniform_wall(1, 0.3, 0.4, 0.1)), uniform_problem(mesh, thin, polished),
        uniform_problem(mesh, thick, uniform_wall(1, 0.3, 0.4, 0)),
        uniform_problem(mesh, uniform_medium(1, 1, 0, 1), uniform_wall(1, 0.3, 0, 0))})
    EXPECT_FALSE(has_note(solve(problem, directions_ldfe_sq(3), {}), "corrected on "));
}

TEST(AngularMultigrid, SameBitsForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(2, 0.1, 2, 1), uniform_wall(2, 0.2, 0.5, 0));
  SolveOptions options = tight_options();
  options.tolerance = 1e-8;
  options.threads = 1;
  const Solution one = solve(problem, directions_ldfe_sq(3), options);
  ASSERT_TRUE(has_note(one, "corrected on "));
  for (const int threads : {2, 3}) {
    options.threads = threads;
    EXPECT_EQ(solve(problem, directions_ldfe_sq(3), options).fluence, one.fluence);
  }
}

// A ring of cells about directions of both sets.
TEST(AngularMultigrid, BreaksCycles) {
  const DirectionSet few = directions_product(8);
  const TetrahedralMesh mesh = cyclic_ring_about(few.direction(OrdinateIndex(0)));
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.3, 2, 1), uniform_wall(1, 0.2, 0.3, 0));
  SolveOptions options = tight_options();
  options.tolerance = 1e-10;
  const Solution corrected = solve(problem, directions_ldfe_sq(3), options);
  ASSERT_TRUE(has_note(corrected, "corrected on "));
  options.angular_multigrid = AngularMultigrid::none;
  const Solution plain = solve(problem, directions_ldfe_sq(3), options);
  ASSERT_GT(plain.lagged_faces, 0);
  ASSERT_TRUE(corrected.converged());
  EXPECT_LT(difference(corrected, plain, 1, 0), 1e-9);
}

TEST(CoarseCorrection, IsGivenUpWhereSweepsAloneGetFurtherTwice) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.1, 5, 1), uniform_wall(1, 0.1, 0.3, 0));
  const DirectionSet many = directions_ldfe_sq(2);
  const std::vector<double> extinction = extinction_of(problem);
  TransportSweep fine(problem, many, extinction, tight_options());
  CoarseDirections directions(fine, directions_product(4));
  const BandVectors vectors(mesh, fine);
  TransportState v(fine.layout());
  fill(v.fluence(), 1);
  const std::vector<char> all(1, 1);
  CoarseCorrection cheap(directions, nullptr, vectors, 0.01), dear(directions, nullptr, vectors, 1);
  for (CoarseCorrection* correction : {&cheap, &dear}) {
    const TransportState z = correction->solve(v, 0.5, all);
    TransportState rest(v.layout());
    directions.apply_linear(z, rest, all);
    vectors.add(rest, {-1}, z);
    vectors.add(rest, {1}, v);
    EXPECT_LT(vectors.norm(rest)[0], 0.5001 * vectors.norm(v)[0]);
  }
  for (int i = 0; i < 3; ++i) cheap.judge({1}, {0.1}, all);
  EXPECT_FALSE(cheap.is_given_up());
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(dear.is_given_up(), i >= 2);
    dear.judge({1}, {0.9}, all);
  }
  cheap.judge({1}, {0.99}, all);
  cheap.judge({1}, {0.1}, all);
  cheap.judge({1}, {0.99}, all);
  EXPECT_FALSE(cheap.is_given_up());
  cheap.judge({1}, {0.99}, all);
  EXPECT_TRUE(cheap.is_given_up());
}

}  // namespace
}  // namespace etendue::angular_multigrid_test
