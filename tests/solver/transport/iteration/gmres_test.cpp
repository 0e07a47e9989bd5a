// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/iteration/gmres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/solution/balance.h"
#include "solver/transport/iteration/band_vectors.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::gmres_test {
namespace {

Solution solved(const Problem& problem, Method method, double tolerance = 1e-11) {
  SolveOptions options = tight_options();
  options.method = method;
  options.tolerance = tolerance;
  return solve(problem, directions_triangular(4), options);
}

TEST(Gmres, AgreesWithSourceIterationInFewerSweeps) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  // Anisotropic scattering, mirrors and diffuse walls, and a different medium in each band.
  Medium medium = uniform_medium(3, 0.1, 0, 0.2, PhaseHenyeyGreenstein{0.5});
  medium.scattering = {Coefficient(0.5), Coefficient(3.0), Coefficient(8.0)};
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(3, 0.3, 0.5, 0.2));
  const Solution iterated = solved(problem, Method::source_iteration);
  const Solution krylov = solved(problem, Method::gmres);
  ASSERT_TRUE(iterated.converged());
  ASSERT_TRUE(krylov.converged());
  EXPECT_EQ(krylov.method, "gmres");
  for (std::size_t band = 0; band < 3; ++band) {
    EXPECT_LT(difference(krylov, iterated, 3, band), 1e-10);
    EXPECT_LT(2 * krylov.convergence[band].sweeps, iterated.convergence[band].sweeps);
  }
  for (const Balance& balance : balances(problem, krylov)) EXPECT_LT(std::abs(balance.residual), 1e-10);
}

TEST(Gmres, ConvergesInThickBrightMedia) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.001, 50, 1), uniform_wall(1, 0, 0, 0));
  const Solution solution = solved(problem, Method::gmres, 1e-8);
  ASSERT_TRUE(solution.converged());
  EXPECT_LT(solution.convergence[0].sweeps, 150);
  EXPECT_LT(std::abs(balances(problem, solution)[0].residual), 1e-6);
}

TEST(Gmres, EstimatedErrorBoundsTheTrueError) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem =
      uniform_problem(mesh, uniform_medium(1, 0.05, 5, 1), uniform_wall(1, 0.2, 0.6, 0.1));
  const Solution exact = solved(problem, Method::gmres, 1e-12);
  for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
    const Solution rough = solved(problem, Method::gmres, tolerance);
    EXPECT_TRUE(rough.converged());
    EXPECT_LT(difference(rough, exact, 1, 0), tolerance);
  }
}

TEST(Gmres, StopsAtTheLimitAndSaysSo) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.001, 20, 1), uniform_wall(1, 0, 0.5, 0));
  SolveOptions options = tight_options();
  options.method = Method::gmres;
  options.max_sweeps = 7;
  const Solution solution = solve(problem, directions_triangular(4), options);
  EXPECT_FALSE(solution.converged());
  EXPECT_EQ(solution.convergence[0].sweeps, 7);
}

TEST(Gmres, RestartsWhereMemoryBoundsItsBasis) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.1, 5, 1), uniform_wall(1, 0.2, 0.5, 0));
  const DirectionSet directions = directions_triangular(4);
  const std::vector<double> extinction(static_cast<std::size_t>(mesh.cell_count()), 5.1);
  SolveOptions options = tight_options();
  TransportSweep sweep(problem, directions, extinction, options);
  TransportState longer(sweep.layout()), shorter(sweep.layout());
  const IterationOptions limits{1e-9, 500};
  const IterationResult one = Gmres().run(sweep, longer, limits, {});
  const IterationResult many = Gmres(0).run(sweep, shorter, limits, {});
  EXPECT_TRUE(one.bands[0].converged);
  EXPECT_TRUE(many.bands[0].converged);
  EXPECT_GT(many.bands[0].sweeps, one.bands[0].sweeps);
  for (std::size_t i = 0; i < longer.fluence().size(); ++i)
    EXPECT_NEAR(shorter.fluence()[i], longer.fluence()[i], 1e-7 * longer.fluence()[i]);
}

/// The end of a run of GMRES whose estimate is trusted or not.
struct Ending {
  IterationResult result;
  double change;  ///< by one more sweep, relative to the largest fluence
};

Ending ending(bool trusts_estimate, int max_sweeps, const SolveObserver& observer = {}) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.1, 5, 1), uniform_wall(1, 0.2, 0.5, 0));
  const DirectionSet directions = directions_triangular(4);
  const std::vector<double> extinction(static_cast<std::size_t>(mesh.cell_count()), 5.1);
  TransportSweep sweep(problem, directions, extinction, tight_options());
  TransportState state(sweep.layout()), next(sweep.layout());
  IterationOptions limits{1e-6, max_sweeps};
  limits.trusts_estimate = trusts_estimate;
  Ending end{Gmres().run(sweep, state, limits, observer), 0};
  sweep.apply(state, next);
  double largest = 0;
  for (std::size_t i = 0; i < state.fluence().size(); ++i) {
    end.change = std::max(end.change, std::abs(next.fluence()[i] - state.fluence()[i]));
    largest = std::max(largest, next.fluence()[i]);
  }
  end.change /= largest;
  return end;
}

TEST(Gmres, LeavesOutTheLastSweepWhereItsEstimateIsTrusted) {
  const Ending confirmed = ending(false, 500), trusted = ending(true, 500);
  EXPECT_TRUE(confirmed.result.bands[0].converged);
  EXPECT_TRUE(trusted.result.bands[0].converged);
  EXPECT_EQ(trusted.result.sweeps, confirmed.result.sweeps - 1);
  EXPECT_LT(trusted.change, 1e-6);
}

TEST(Gmres, DoesNotTrustWhatItHasNotFinished) {
  EXPECT_FALSE(ending(true, 4).result.bands[0].converged);
  const Ending stopped = ending(true, 500, [](const SweepProgress& progress) {
    return progress.sweep < 3 ? SolveControl::proceed : SolveControl::stop;
  });
  EXPECT_TRUE(stopped.result.interrupted);
  EXPECT_FALSE(stopped.result.bands[0].converged);
}

TEST(Gmres, SameBitsForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(2, 0.1, 2, 1, PhaseHenyeyGreenstein{0.4}),
                                          uniform_wall(2, 0.2, 0.5, 0.1));
  SolveOptions options = tight_options();
  options.method = Method::gmres;
  options.tolerance = 1e-7;
  options.threads = 1;
  const Solution one = solve(problem, directions_ldfe_sq(1), options);
  for (const int threads : {2, 3, 4}) {
    options.threads = threads;
    EXPECT_EQ(solve(problem, directions_ldfe_sq(1), options).fluence, one.fluence);
  }
}

TEST(TransportSweep, LinearPartIsTheDifferenceOfTwoSweeps) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.1, 2, 1, PhaseHenyeyGreenstein{0.4}),
                                          uniform_wall(1, 0.2, 0.4, 0.3));
  const DirectionSet directions = directions_triangular(4);
  const std::vector<double> extinction(static_cast<std::size_t>(mesh.cell_count()), 2.1);
  const SolveOptions options = tight_options();
  TransportSweep sweep(problem, directions, extinction, options);
  TransportState zero(sweep.layout()), first(sweep.layout()), second(sweep.layout()), linear(sweep.layout());
  sweep.apply(zero, first);
  sweep.apply(first, second);
  sweep.apply_linear(first, linear);
  for (std::size_t i = 0; i < linear.values().size(); ++i)
    EXPECT_NEAR(linear.values()[i], second.values()[i] - first.values()[i], 1e-12);
}

}  // namespace
}  // namespace etendue::gmres_test
