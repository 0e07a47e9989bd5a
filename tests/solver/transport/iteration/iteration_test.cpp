// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "solver/solution/balance.h"
#include "solver/transport/iteration/source_iteration.h"
#include "solver/transport/solve/solve.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::iteration_test {
namespace {

Problem hazy_room(const TetrahedralMesh& mesh, int bands) {
  return uniform_problem(mesh, uniform_medium(bands, 0.2, 1.5, 0.1, PhaseHenyeyGreenstein{0.5}),
                         uniform_wall(bands, 0.4, 0.4, 0.1));
}

SolveOptions source_iteration() {
  SolveOptions options = tight_options();
  options.method = Method::source_iteration;
  return options;
}

TEST(SourceIteration, EstimatedErrorIsTheTrueErrorWithinAFactor) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = hazy_room(mesh, 1);
  const DirectionSet directions = directions_triangular(4);
  const Solution exact = solve(problem, directions, source_iteration());
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    SolveOptions options = source_iteration();
    options.tolerance = tolerance;
    const Solution rough = solve(problem, directions, options);
    double error = 0, norm = 0;
    for (std::size_t i = 0; i < exact.fluence.size(); ++i) {
      const double volume = mesh.volumes()[i / 4];
      error += volume * std::pow(rough.fluence[i] - exact.fluence[i], 2);
      norm += volume * std::pow(exact.fluence[i], 2);
    }
    EXPECT_TRUE(rough.converged());
    EXPECT_LT(std::sqrt(error / norm), tolerance);
    EXPECT_GT(std::sqrt(error / norm), tolerance / 200) << "far more sweeps than were asked for";
  }
}

TEST(SourceIteration, OneSweepSolvesWhatNeitherScattersNorReflects) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 1, 0, 1), uniform_wall(1, 0, 0, 0));
  const Solution solution = solve(problem, directions_triangular(4), SolveOptions{});
  EXPECT_TRUE(solution.converged());
  EXPECT_EQ(solution.convergence[0].sweeps, 1);
}

TEST(SourceIteration, NotConvergedIsAResultThatSaysSo) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  SolveOptions options = source_iteration();
  options.max_sweeps = 4;
  const Solution solution = solve(hazy_room(mesh, 2), directions_triangular(4), options);
  EXPECT_FALSE(solution.converged());
  for (const BandConvergence& band : solution.convergence) {
    EXPECT_EQ(band.sweeps, 4);
    EXPECT_GT(band.residual, options.tolerance);
  }
}

TEST(SourceIteration, TheOnlySweepAllowedIsTheOnlyOneDone) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  SolveOptions options = source_iteration();
  options.max_sweeps = 1;
  const Solution solution = solve(hazy_room(mesh, 1), directions_triangular(4), options);
  EXPECT_EQ(solution.convergence[0].sweeps, 1);
  EXPECT_FALSE(solution.converged());
}

TEST(SourceIteration, ObserverStopsItAndSeesFallingErrors) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  std::vector<double> errors;
  const Solution solution = solve(hazy_room(mesh, 1), directions_triangular(4), source_iteration(),
                                  [&](const SweepProgress& progress) {
                                    errors.push_back(progress.residual[0]);
                                    return progress.sweep == 6 ? SolveControl::stop : SolveControl::proceed;
                                  });
  EXPECT_TRUE(solution.interrupted);
  EXPECT_FALSE(solution.converged());
  ASSERT_EQ(errors.size(), 6u);
  EXPECT_LT(errors[5], errors[2]);
}

TEST(RateEstimate, KnowsAGeometricSequence) {
  RateEstimate rate;
  double residual = 1, error = 0;
  for (int i = 0; i < 10; ++i) error = rate.error(residual *= 0.8);
  EXPECT_NEAR(error, residual / (1 - 0.8), 1e-12);
  EXPECT_NEAR(rate.sweeps_left(error * std::pow(0.8, 7.5)), 8, 1e-9);
}

TEST(Threads, GiveTheSameBits) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  for (const int bands : {1, 3}) {
    const Problem problem = hazy_room(mesh, bands);
    SolveOptions options = tight_options(Lumping::automatic);
    options.tolerance = 1e-6;
    options.keep_ordinates = {3};
    options.threads = 1;
    const Solution one = solve(problem, directions_triangular(4), options);
    for (const int threads : {2, 3, 4}) {
      options.threads = threads;
      const Solution many = solve(problem, directions_triangular(4), options);
      EXPECT_EQ(many.fluence, one.fluence);
      EXPECT_EQ(many.net_flux, one.net_flux);
      EXPECT_EQ(many.irradiance, one.irradiance);
      EXPECT_EQ(many.exitance, one.exitance);
      EXPECT_EQ(many.radiance[0].values, one.radiance[0].values);
      EXPECT_EQ(many.convergence[0].sweeps, one.convergence[0].sweeps);
    }
  }
}

TEST(SweepOrders, RecomputedOrdersGiveTheSameBits) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = hazy_room(mesh, 1);
  SolveOptions options = source_iteration();
  options.tolerance = 1e-6;
  const Solution kept = solve(problem, directions_triangular(4), options);
  options.order_memory = 0;
  const Solution recomputed = solve(problem, directions_triangular(4), options);
  EXPECT_EQ(recomputed.fluence, kept.fluence);
}

TEST(SweepTiles, GiveTheSolutionOfOneSweepAfterTheOther) {
  const TetrahedralMesh mesh = cube_mesh(5e-4);
  for (const int bands : {1, 3}) {
    const Problem problem = hazy_room(mesh, bands);
    SolveOptions options = source_iteration();
    options.tolerance = 1e-6;
    options.keep_ordinates = {7};
    const Solution whole = solve(problem, directions_triangular(4), options);
    options.cache_bytes = 0;
    options.threads = 1;
    const Solution tiled = solve(problem, directions_triangular(4), options);
    options.threads = 2;
    const Solution shared = solve(problem, directions_triangular(4), options);
    ASSERT_EQ(tiled.fluence.size(), whole.fluence.size());
    for (std::size_t i = 0; i < whole.fluence.size(); ++i)
      EXPECT_NEAR(tiled.fluence[i], whole.fluence[i], 1e-13 * std::abs(whole.fluence[i]) + 1e-14);
    EXPECT_EQ(shared.fluence, tiled.fluence);
    EXPECT_EQ(shared.net_flux, tiled.net_flux);
    EXPECT_EQ(tiled.radiance[0].values.size(), whole.radiance[0].values.size());
  }
}

TEST(Memory, EstimateGrowsWithMomentsThreadsAndDirections) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  const Problem hazy = hazy_room(mesh, 1);
  const Problem clear = uniform_problem(mesh, uniform_medium(1, 0.2, 1.5, 0.1), uniform_wall(1, 0.4, 0.5, 0));
  SolveOptions options = tight_options();
  const std::size_t least = estimate_memory(clear, directions_ldfe_sq(1), options);
  // At least the Krylov vectors of the fluence, at most a hundred times as much.
  const std::size_t fluence = static_cast<std::size_t>(mesh.cell_count()) * 4 * sizeof(double);
  EXPECT_GT(least, 20 * fluence);
  EXPECT_LT(least, 200 * fluence);
  EXPECT_GT(estimate_memory(hazy, directions_ldfe_sq(1), options), 5 * least);
  EXPECT_GT(estimate_memory(clear, directions_ldfe_sq(2), options), least);
  options.threads = 4;
  EXPECT_GT(estimate_memory(clear, directions_ldfe_sq(1), options), least);
  options.threads = tight_options().threads;
  options.precision = Precision::mixed;
  EXPECT_GT(estimate_memory(clear, directions_ldfe_sq(1), options), least);
}

TEST(Meters, AddUpToTheNetFlux) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = hazy_room(mesh, 3);
  const Vec3 point(0.31, 0.47, 0.23), normal = Vec3(1, -2, 0.5).normalized();
  const CellLocator locator(mesh);
  SolveOptions options = source_iteration();
  options.meters = {{locator.find(point), normal}, {locator.find(point), -normal}};
  const Solution solution = solve(problem, directions_triangular(4), options);
  // Light on one side less light on the other is the flux through the meter.
  const CellPoint at = locator.find(point).front();
  for (std::size_t b = 0; b < 3; ++b) {
    double flux = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        flux += at.barycentric[i] * normal[static_cast<Eigen::Index>(axis)] *
                solution.net_flux[((at.cell.at() * 4 + i) * 3 + axis) * 3 + b];
    EXPECT_NEAR(solution.meters[3 + b] - solution.meters[b], flux, 1e-12);
    EXPECT_GT(solution.meters[b], 0);
  }
}

}  // namespace
}  // namespace etendue::iteration_test
