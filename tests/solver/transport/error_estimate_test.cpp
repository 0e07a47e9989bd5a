// SPDX-License-Identifier: AGPL-3.0-or-later
//
// In thick media of high albedo a small residual does not bound the error: "converged" must mean that the
// error is below the tolerance on every path.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/solver/transport/sample_problems.h"

namespace etendue::error_estimate_test {
namespace {

/// A cube that only scatters, lit from below.
Problem lit_cube(const TetrahedralMesh& mesh, double scattering) {
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, name == "zmin" ? 1 : 0, 0, 0));
    walls.back().name = name;
  }
  Medium medium = uniform_medium(1, 0, scattering, 0);
  medium.name = mesh.region_names().front();
  return Problem(mesh, Bands{}, {medium}, walls);
}

Solution solved(const Problem& problem, const SolveOptions& options) {
  return solve(problem, directions_triangular(4), options);
}

SolveOptions plain(Method method, double tolerance, SpaceOrder order = SpaceOrder::linear) {
  SolveOptions options = tight_options();
  options.order = order;
  options.method = method;
  options.acceleration = Acceleration::none;
  options.tolerance = tolerance;
  options.max_sweeps = 4000;
  return options;
}

Solution exact_of(const Problem& problem, SpaceOrder order) {
  SolveOptions options = plain(Method::gmres, 1e-9, order);
  options.acceleration = Acceleration::diffusion;
  return solved(problem, options);
}

/// The error may be larger than its estimate by this.
constexpr double allowed = 3;

TEST(ErrorEstimate, OfPlainGmresHoldsInThickMediaBeyondARestart) {
  const TetrahedralMesh mesh = cube_mesh(5e-2);
  for (const double scattering : {1e3, 3e4}) {
    const Problem problem = lit_cube(mesh, scattering);
    const Solution exact = exact_of(problem, SpaceOrder::linear);
    for (const double tolerance : {1e-2, 1e-4}) {
      SolveOptions options = plain(Method::gmres, tolerance);
      options.max_sweeps = 600;
      const Solution solution = solved(problem, options);
      EXPECT_GT(solution.convergence[0].sweeps, 50) << "no restart";
      if (solution.converged())
        EXPECT_LT(difference(solution, exact, 1, 0), allowed * tolerance) << scattering;
      else
        EXPECT_GT(solution.convergence[0].residual, tolerance);
    }
  }
}

TEST(ErrorEstimate, OfPlainPathsHoldsFromAnEarlierState) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  for (const SpaceOrder order : {SpaceOrder::linear, SpaceOrder::constant})
    for (const Method method : {Method::gmres, Method::source_iteration}) {
      const Problem problem = lit_cube(mesh, 50);
      const Solution exact = exact_of(problem, order);
      SolveOptions options = plain(method, 1e-3, order);
      options.max_sweeps = 6;
      const Solution first = solved(problem, options);
      EXPECT_FALSE(first.converged());
      options.initial = &first.state;
      options.max_sweeps = 20000;
      const Solution second = solved(problem, options);
      EXPECT_TRUE(second.converged());
      EXPECT_LT(difference(second, exact, 1, 0), allowed * 1e-3) << second.method;
    }
}

TEST(ErrorEstimate, OfSourceIterationHoldsWhereItLeavesDiffusion) {
  const TetrahedralMesh mesh = random_cells(cube_mesh(1e-2));
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names()) {
    media.push_back(name == "ball" ? uniform_medium(1, 0.1, 1e4, 1) : uniform_medium(1, 1e-4, 1e-3, 1));
    media.back().name = name;
  }
  std::vector<Wall> walls(mesh.wall_names().size(), uniform_wall(1, 0, 0, 0));
  for (std::size_t i = 0; i < walls.size(); ++i) walls[i].name = mesh.wall_names()[i];
  const Problem problem(mesh, Bands{}, media, walls);
  const Solution exact = exact_of(problem, SpaceOrder::linear);
  SolveOptions options = plain(Method::source_iteration, 1e-5);
  options.acceleration = Acceleration::diffusion;
  const Solution solution = solved(problem, options);
  if (solution.converged())
    EXPECT_LT(difference(solution, exact, 1, 0), allowed * 1e-5);
  else
    EXPECT_GT(solution.convergence[0].residual, 1e-5);
}

TEST(ErrorEstimate, StopsWhereOnlyRoundingIsLeft) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  SolveOptions options = plain(Method::gmres, 1e-11);
  options.acceleration = Acceleration::diffusion;
  const Solution solution = solved(lit_cube(mesh, 3e4), options);
  EXPECT_FALSE(solution.converged());
  EXPECT_LT(solution.convergence[0].sweeps, 100);
  EXPECT_EQ(std::count_if(solution.notes.begin(), solution.notes.end(),
                          [](const std::string& note) { return note.starts_with("rounding leaves"); }),
            1);
}

TEST(ErrorEstimate, EverySweepThatIsAllowedCounts) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const Problem problem = lit_cube(mesh, 3);
  const Solution exact = exact_of(problem, SpaceOrder::linear);
  double last = 1;
  for (const int sweeps : {1, 2, 3, 5}) {
    SolveOptions options = plain(Method::gmres, 1e-9);
    options.max_sweeps = sweeps;
    const double error = difference(solved(problem, options), exact, 1, 0);
    EXPECT_LT(error, last) << sweeps;
    last = error;
  }
}

}  // namespace
}  // namespace etendue::error_estimate_test
