// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Scattering through matrices, and delta-M, in whole solutions.
#include "solver/transport/scattering/dense_scattering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/solution/balance.h"
#include "solver/transport/scattering/scattering_plan.h"
#include "solver/transport/solve/solve.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::dense_scattering_test {
namespace {

constexpr double four_pi = 4 * std::numbers::pi;

Medium scattering_by(ScatteringChoice choice, double absorption, double scattering, double emission,
                     PhaseFunction phase, int bands = 1) {
  Medium medium = uniform_medium(bands, absorption, scattering, emission, std::move(phase));
  medium.choice.assign(static_cast<std::size_t>(bands), choice);
  return medium;
}

constexpr ScatteringChoice dense{ScatteringBackend::dense, -1, ForwardPeak::automatic};
constexpr ScatteringChoice galerkin{ScatteringBackend::galerkin, -1, ForwardPeak::automatic};
constexpr ScatteringChoice moments{ScatteringBackend::moments, -1, ForwardPeak::keep};
constexpr ScatteringChoice delta_m{ScatteringBackend::moments, -1, ForwardPeak::delta_m};

/// One side shines, the others are black.
std::vector<Wall> lit_from_below(const TetrahedralMesh& mesh, int bands = 1) {
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(bands, name == "zmin" ? 1 : 0, name == "xmax" ? 0.5 : 0, 0));
    walls.back().name = name;
  }
  return walls;
}

void expect_balance(const Problem& problem, const Solution& solution) {
  for (const Balance& balance : balances(problem, solution)) EXPECT_LT(std::abs(balance.residual), 1e-10);
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0, scale = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(a[i] - b[i]));
    scale = std::max(scale, std::abs(b[i]));
  }
  return largest / scale;
}

TEST(DenseScattering, KeepsConstantRadianceConstant) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  for (const SpaceOrder order : {SpaceOrder::linear, SpaceOrder::constant})
    for (const Lumping lumping : {Lumping::none, Lumping::mass}) {
      const Problem problem =
          uniform_problem(mesh, scattering_by(dense, 0.4, 3, 0.4 * 2.5, PhaseHenyeyGreenstein{0.9}, 3),
                          uniform_wall(3, 0.7 * 2.5, 0.3, 0));
      SolveOptions options = tight_options(lumping);
      options.order = order;
      const Solution solution = solve(problem, directions_ldfe_sq(1), options);
      ASSERT_TRUE(solution.converged());
      EXPECT_LT(largest_deviation(solution.fluence, four_pi * 2.5), 1e-10);
      expect_balance(problem, solution);
    }
}

TEST(DenseScattering, WithoutAbsorptionLosesNothing) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  for (const double g : {0.5, 0.95}) {
    const Problem problem(mesh, Bands{}, {scattering_by(dense, 0, 4, 0, PhaseHenyeyGreenstein{g})},
                          lit_from_below(mesh));
    const Solution solution = solve(problem, directions_ldfe_sq(1), tight_options());
    ASSERT_TRUE(solution.converged());
    const Balance balance = balances(problem, solution).front();
    EXPECT_EQ(balance.absorbed, 0);
    EXPECT_GT(balance.inflow, 1);
    expect_balance(problem, solution);
  }
}

TEST(DenseScattering, StraightAheadEqualsNoScattering) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const Problem clear(mesh, Bands{}, {uniform_medium(1, 0.3, 0, 0.2)}, lit_from_below(mesh));
  const Solution expected = solve(clear, directions_ldfe_sq(1), tight_options());
  for (const ScatteringChoice choice : {dense, galerkin}) {
    const Problem problem(mesh, Bands{},
                          {scattering_by(choice, 0.3, 5, 0.2, PhaseHenyeyGreenstein{1 - 1e-13})},
                          lit_from_below(mesh));
    const Solution solution = solve(problem, directions_ldfe_sq(1), tight_options());
    ASSERT_TRUE(solution.converged());
    EXPECT_LT(largest_difference(solution.fluence, expected.fluence), 1e-10);
    EXPECT_LT(largest_difference(solution.exitance, expected.exitance), 1e-10);
  }
}

TEST(DenseScattering, ByGalerkinEqualsTheMomentsOfAShortSeries) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const PhaseFunction phase = PhaseLegendre{{1, 0.4, 0.15, 0.05}};
  std::vector<Solution> solutions;
  for (const ScatteringChoice choice : {galerkin, moments}) {
    const Problem problem(mesh, Bands{}, {scattering_by(choice, 0.3, 2, 0.2, phase)}, lit_from_below(mesh));
    solutions.push_back(solve(problem, directions_triangular(6), tight_options()));
    ASSERT_TRUE(solutions.back().converged());
  }
  EXPECT_LT(largest_difference(solutions[0].fluence, solutions[1].fluence), 1e-10);
  EXPECT_LT(largest_difference(solutions[0].net_flux, solutions[1].net_flux), 1e-10);
}

TEST(DenseScattering, OfOneBandLeavesTheOthersToTheirMoments) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const PhaseFunction peak = PhaseHenyeyGreenstein{0.9}, smooth = PhaseHenyeyGreenstein{0.4};
  Medium both = uniform_medium(2, 0.3, 2, 0.2);
  both.phase = {peak, smooth};
  both.choice = {dense, moments};
  Bands bands;
  bands.names = {"a", "b"};
  const Problem together(mesh, bands, {both}, lit_from_below(mesh, 2));
  const Solution solution = solve(together, directions_ldfe_sq(1), tight_options());
  ASSERT_TRUE(solution.converged());
  expect_balance(together, solution);
  for (std::size_t band = 0; band < 2; ++band) {
    const Problem alone(mesh, Bands{},
                        {scattering_by(band == 0 ? dense : moments, 0.3, 2, 0.2, band == 0 ? peak : smooth)},
                        lit_from_below(mesh));
    const Solution expected = solve(alone, directions_ldfe_sq(1), tight_options());
    std::vector<double> of_band;
    for (std::size_t i = band; i < solution.fluence.size(); i += 2) of_band.push_back(solution.fluence[i]);
    EXPECT_LT(largest_difference(of_band, expected.fluence), 1e-10);
  }
}

TEST(DenseScattering, InOneRegionLeavesTheOtherAlone) {
  const TetrahedralMesh mesh = cube_with_ball(2e-2);
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names()) {
    media.push_back(name == "ball" ? scattering_by(dense, 0.5, 4, 0.5 * 3, PhaseHenyeyGreenstein{0.85})
                                   : scattering_by(moments, 0.2, 1, 0.2 * 3, PhaseHenyeyGreenstein{0.4}));
    media.back().name = name;
  }
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0.4 * 3, 0.2, 0.4));
    walls.back().name = name;
  }
  const Problem problem(mesh, Bands{}, media, walls);
  const Solution solution = solve(problem, directions_ldfe_sq(1), tight_options(Lumping::automatic));
  ASSERT_TRUE(solution.converged());
  EXPECT_LT(largest_deviation(solution.fluence, four_pi * 3), 1e-10);
  ASSERT_EQ(solution.kernels.size(), 2u);
  for (const KernelReport& kernel : solution.kernels) {
    EXPECT_EQ(kernel.backend.rfind(kernel.medium == "ball" ? "dense" : "moments", 0), 0u);
    EXPECT_NEAR(kernel.asymmetry, kernel.medium == "ball" ? 0.85 : 0.4, 1e-10);
    EXPECT_LT(kernel.energy_error, 1e-12);
  }
}

TEST(DenseScattering, GivesTheSameBitsForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = cube_mesh(4e-3);
  const Problem problem(mesh, Bands{}, {scattering_by(dense, 0.1, 3, 0.2, PhaseHenyeyGreenstein{0.8})},
                        lit_from_below(mesh));
  SolveOptions options;
  options.tolerance = 1e-4;
  options.threads = 1;
  const Solution one = solve(problem, directions_ldfe_sq(1), options);
  options.threads = 3;
  const Solution three = solve(problem, directions_ldfe_sq(1), options);
  EXPECT_EQ(one.fluence, three.fluence);
  EXPECT_EQ(one.net_flux, three.net_flux);
}

TEST(DeltaM, KeepsConstantRadianceAndTheBalance) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const Problem furnace =
      uniform_problem(mesh, scattering_by(delta_m, 0.4, 3, 0.4 * 2.5, PhaseHenyeyGreenstein{0.9}),
                      uniform_wall(1, 0.7 * 2.5, 0.3, 0));
  const Solution solution = solve(furnace, directions_ldfe_sq(1), tight_options());
  ASSERT_TRUE(solution.converged());
  EXPECT_LT(largest_deviation(solution.fluence, four_pi * 2.5), 1e-10);
  expect_balance(furnace, solution);
  EXPECT_NEAR(solution.kernels[0].asymmetry, 0.9, 1e-12);
  EXPECT_NEAR(solution.kernels[0].largest_forward, std::pow(0.9, 8), 1e-12);
}

TEST(ScatteringPlan, TakesMomentsWhereTheSeriesEndsAndAMatrixWhereItDoesNot) {
  const TetrahedralMesh mesh = cube_mesh(3e-2);
  const auto backend = [&](PhaseFunction phase) {
    const Problem problem =
        uniform_problem(mesh, uniform_medium(1, 1, 1, 1, std::move(phase)), Wall{uniform_wall(1, 0, 0, 0)});
    return plan_scattering(problem, directions_ldfe_sq(1)).front();
  };
  EXPECT_EQ(backend(PhaseIsotropic{}).backend, ScatteringBackend::moments);
  EXPECT_EQ(backend(PhaseRayleigh{}).degree, 2);
  EXPECT_EQ(backend(PhaseHenyeyGreenstein{0.5}).backend, ScatteringBackend::moments);
  EXPECT_EQ(backend(PhaseHenyeyGreenstein{0.8}).backend, ScatteringBackend::dense);
  EXPECT_NE(backend(PhaseHenyeyGreenstein{0.8}).reason.find("moments of degree 7 would leave 0.17 out"),
            std::string::npos)
      << backend(PhaseHenyeyGreenstein{0.8}).reason;
}

// 64 moments, 96 ordinates, three bands: measured about 0.8.
TEST(DenseScattering, CostsLessThanTwiceTheMomentsOfDegreeSeven) {
  const TetrahedralMesh mesh = cube_mesh(2e-3);
  std::vector<double> cost;
  for (ScatteringChoice choice : {moments, dense}) {
    if (choice.backend == ScatteringBackend::moments) choice.degree = 7;
    Medium fog = uniform_medium(3, 0.1, 2, 0, PhaseHenyeyGreenstein{0.8});
    fog.choice.assign(3, choice);
    const Problem problem(mesh, Bands{{"a", "b", "c"}, {}}, {fog}, lit_from_below(mesh, 3));
    SolveOptions options;
    options.threads = 1;
    options.max_sweeps = 8;
    options.acceleration = Acceleration::none;
    cost.push_back(solve(problem, directions_ldfe_sq(1), options).sweep_cost);
  }
  EXPECT_LT(cost[1], 2 * cost[0]);
}

TEST(MemoryEstimate, CountsTheAngularSolutionOfDenseCells) {
  const TetrahedralMesh mesh = cube_mesh(4e-3);
  const auto estimate = [&](ScatteringChoice choice, const DirectionSet& set) {
    const Problem problem = uniform_problem(mesh, scattering_by(choice, 1, 1, 1, PhaseHenyeyGreenstein{0.9}),
                                            uniform_wall(1, 0, 0, 0));
    SolveOptions options;
    options.threads = 1;
    return static_cast<double>(estimate_memory(problem, set, options));
  };
  const double angular = 8.0 * mesh.cell_count() * 4 * 384;
  EXPECT_GT(estimate(dense, directions_ldfe_sq(2)), estimate(moments, directions_ldfe_sq(2)) + 5 * angular);
}

}  // namespace
}  // namespace etendue::dense_scattering_test
