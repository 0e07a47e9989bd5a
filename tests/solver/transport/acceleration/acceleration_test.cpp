// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "solver/solution/balance.h"
#include "solver/solution/solve_observer.h"
#include "solver/transport/acceleration/diffusion_acceleration.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::acceleration_test {
namespace {

SolveOptions options_of(Method method, Acceleration acceleration, double tolerance = 1e-8) {
  SolveOptions options = tight_options(Lumping::automatic);
  options.method = method;
  options.acceleration = acceleration;
  options.tolerance = tolerance;
  return options;
}

bool says(const Solution& solution, const std::string& text) {
  return std::any_of(solution.notes.begin(), solution.notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

TEST(DiffusionAcceleration, EveryPathGivesTheSameAnswer) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  // Different media in three bands, anisotropic scattering, diffuse and mirror reflection.
  Medium medium = uniform_medium(3, 0.05, 0, 0.2, PhaseHenyeyGreenstein{0.4});
  medium.scattering = {Coefficient(0.5), Coefficient(3.0), Coefficient(6.0)};
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(3, 0.3, 0.4, 0.2));
  const DirectionSet directions = directions_triangular(4);
  const double tolerance = 1e-9;
  const Solution plain =
      solve(problem, directions, options_of(Method::source_iteration, Acceleration::none, tolerance));
  ASSERT_TRUE(plain.converged());
  for (const Method method : {Method::gmres, Method::source_iteration})
    for (const Acceleration acceleration : {Acceleration::none, Acceleration::diffusion})
      for (const int threads : {1, 3}) {
        SolveOptions options = options_of(method, acceleration, tolerance);
        options.threads = threads;
        const Solution solution = solve(problem, directions, options);
        ASSERT_TRUE(solution.converged());
        EXPECT_TRUE(says(solution, std::to_string(threads) + " threads"));
        for (std::size_t band = 0; band < 3; ++band) EXPECT_LT(difference(solution, plain, 3, band), 1e-8);
        for (const Balance& balance : balances(problem, solution))
          EXPECT_LT(std::abs(balance.residual), 1e-8);
      }
}

TEST(DiffusionAcceleration, IsLeftOutWhereLittleComesBack) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const SolveOptions options = options_of(Method::gmres, Acceleration::automatic);
  // Mirrors only send light on.
  const Problem dark =
      uniform_problem(mesh, uniform_medium(1, 1, 0.9, 1, PhaseIsotropic{}), uniform_wall(1, 0, 0.2, 0.7));
  const Problem bright =
      uniform_problem(mesh, uniform_medium(1, 1, 1.1, 1, PhaseIsotropic{}), uniform_wall(1, 0, 0.2, 0.7));
  const Problem grey =
      uniform_problem(mesh, uniform_medium(1, 0.05, 0.2, 1, PhaseIsotropic{}), uniform_wall(1, 0, 0.6, 0));
  const Problem white =
      uniform_problem(mesh, uniform_medium(1, 1, 0, 1, PhaseIsotropic{}), uniform_wall(1, 0, 0.9, 0));
  EXPECT_TRUE(says(solve(dark, directions_triangular(4), options), "send back at most 0.47 of the light"));
  EXPECT_TRUE(says(solve(bright, directions_triangular(4), options), "accelerated by diffusion"));
  EXPECT_TRUE(says(solve(grey, directions_triangular(4), options), "scatters only 0.13 times"));
  EXPECT_TRUE(says(solve(white, directions_triangular(4), options), "accelerated by diffusion"));
}

TEST(DiffusionAcceleration, ThicknessDoesNotMatter) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const double size = std::cbrt(6 * std::sqrt(2.0) / mesh.cell_count());
  for (const Lumping lumping : {Lumping::none, Lumping::mass})
    for (const double thickness : {0.1, 1.0, 4.0, 10.0, 100.0, 1000.0}) {
      const Problem problem =
          uniform_problem(mesh, uniform_medium(1, 0, thickness / size, 1), uniform_wall(1, 0, 0, 0));
      SolveOptions options = options_of(Method::gmres, Acceleration::diffusion);
      options.lumping = lumping;
      const Solution solution = solve(problem, directions_triangular(4), options);
      EXPECT_TRUE(solution.converged());
      EXPECT_LE(solution.convergence[0].sweeps, 16) << "cells of " << thickness << " free paths";
    }
}

TEST(DiffusionAcceleration, EstimatedErrorIsTheTrueErrorWithinAFactor) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  for (const double scattering : {1.0, 20.0}) {
    const Problem problem =
        uniform_problem(mesh, uniform_medium(1, 0.001, scattering, 1), uniform_wall(1, 0.2, 0.5, 0));
    const Solution exact =
        solve(problem, directions_triangular(4), options_of(Method::gmres, Acceleration::diffusion, 1e-11));
    for (const Method method : {Method::gmres, Method::source_iteration})
      for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
        const Solution rough =
            solve(problem, directions_triangular(4), options_of(method, Acceleration::diffusion, tolerance));
        ASSERT_TRUE(rough.converged());
        // P is not quite the inverse: |P r| is within about 1.5 of the error.
        EXPECT_LT(difference(rough, exact, 1, 0), 1.5 * tolerance);
        EXPECT_GT(difference(rough, exact, 1, 0), tolerance / 1000) << "far more sweeps than were asked for";
      }
  }
}

/// Sweeps to 1e-8 with these extinctions in the region "ball" and outside, without absorption.
int sweeps_of(const TetrahedralMesh& mesh, double inside, double outside, DiffusionLength length) {
  std::vector<Medium> media;
  for (const std::string& name : mesh.region_names()) {
    media.push_back(uniform_medium(1, 0, name == "ball" ? inside : outside, 1));
    media.back().name = name;
  }
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0.1, 0, 0));
    walls.back().name = name;
  }
  const Problem problem(mesh, Bands{}, media, walls);
  SolveOptions options = options_of(Method::gmres, Acceleration::diffusion);
  options.diffusion_length = length;
  options.lumping = Lumping::none;
  const Solution solution = solve(problem, directions_ldfe_sq(1), options);
  EXPECT_TRUE(solution.converged());
  return solution.convergence[0].sweeps;
}

TEST(DiffusionAcceleration, VoidsBesideThickMatterTakeFewSweeps) {
  const TetrahedralMesh mesh = cube_with_ball(5e-3);
  EXPECT_LE(sweeps_of(mesh, 100, 1e-8, DiffusionLength::automatic), 22);
  EXPECT_LE(sweeps_of(mesh, 1e-8, 100, DiffusionLength::automatic), 22);
  EXPECT_LE(sweeps_of(mesh, 0, 200, DiffusionLength::automatic), 28);
}

TEST(DiffusionAcceleration, NonlocalCoefficientServesContrastFromCellToCell) {
  const TetrahedralMesh mesh = random_cells(cube_mesh(1e-2));
  EXPECT_LE(sweeps_of(mesh, 100, 1, DiffusionLength::automatic), 22);
  const int nonlocal = sweeps_of(mesh, 1000, 0.1, DiffusionLength::automatic);
  EXPECT_LE(nonlocal, 28);
  EXPECT_GT(sweeps_of(mesh, 1000, 0.1, DiffusionLength::local), nonlocal + 5);
}

TEST(DiffusionAcceleration, DiffuseEnclosureInVacuumTakesFewSweeps) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0, 0, 0), uniform_wall(1, 1, 0.95, 0));
  const Solution solution =
      solve(problem, directions_ldfe_sq(1), options_of(Method::gmres, Acceleration::diffusion));
  EXPECT_TRUE(solution.converged());
  EXPECT_LE(solution.convergence[0].sweeps, 25);
  // Everywhere the radiance of the walls, multiplied by their reflections, as in a furnace.
  EXPECT_LT(largest_deviation(solution.fluence, 4 * M_PI / 0.05), 1e-6);
}

TEST(DiffusionAcceleration, MirrorsOnFiveSidesTakeFewSweepsInThinAndThickMedia) {
  const TetrahedralMesh mesh = cube_mesh(3.5e-3);
  const double size = std::cbrt(6 * std::sqrt(2.0) / mesh.cell_count());
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(uniform_wall(1, 0, 0, name == "zmax" ? 0 : 1));
    walls.back().name = name;
  }
  for (const double thickness : {0.1, 1.0, 10.0}) {
    const Problem problem(mesh, Bands{}, {uniform_medium(1, 0, thickness / size, 1)}, walls);
    const Solution solution =
        solve(problem, directions_ldfe_sq(1), options_of(Method::gmres, Acceleration::diffusion));
    EXPECT_TRUE(solution.converged());
    EXPECT_LE(solution.convergence[0].sweeps, 25) << "cells of " << thickness << " free paths";
  }
}

TEST(DiffusionAcceleration, SameBitsForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(2, 0.1, 5, 1, PhaseHenyeyGreenstein{0.4}),
                                          uniform_wall(2, 0.2, 0.5, 0.1));
  SolveOptions options = options_of(Method::gmres, Acceleration::diffusion, 1e-7);
  const Solution one = solve(problem, directions_triangular(6), options);
  for (const int threads : {2, 4}) {
    options.threads = threads;
    EXPECT_EQ(solve(problem, directions_triangular(6), options).fluence, one.fluence);
  }
}

TEST(DiffusionAcceleration, BandsWithEqualCoefficientsShareOneSolver) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  Medium medium = uniform_medium(3, 0.1, 5, 1);
  medium.scattering[1] = Coefficient(7);
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(3, 0.2, 0.5, 0));
  std::vector<double> extinction;
  for (std::size_t i = 0; i < problem.scattering().size(); ++i)
    extinction.push_back(problem.scattering()[i] + problem.absorption()[i]);
  const DirectionSet directions = directions_triangular(4);
  TransportSweep sweep(problem, directions, extinction, tight_options());
  EXPECT_EQ(DiffusionAcceleration(problem, sweep, extinction).solver_count(), 2);
}

/// Relative, in the mean square, of the fluence of a band from a constant.
double deviation(const Solution& solution, std::size_t bands, std::size_t band, double expected) {
  double sum = 0;
  for (std::size_t i = band; i < solution.fluence.size(); i += bands)
    sum += std::pow(solution.fluence[i] / expected - 1, 2);
  return std::sqrt(sum * static_cast<double>(bands) / static_cast<double>(solution.fluence.size()));
}

/// Two bands in a closed box, the second one absorbing well.
Problem closed_box(const TetrahedralMesh& mesh, double absorption, double diffuse) {
  Medium medium = uniform_medium(2, absorption, 1, 1);
  medium.absorption[1] = Coefficient(0.5);
  medium.emission[1] = Coefficient(0.5);
  return uniform_problem(mesh, medium, uniform_wall(2, 0, diffuse, 1 - diffuse));
}

TEST(DiffusionAcceleration, ClosedBoxNeverConvergesToAWrongAnswer) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const double tolerance = 0.02;
  for (const double diffuse : {0.0, 1.0})
    for (const double absorption : {1e-8, 1e-12, 1e-15, 1e-18})
      for (const Method method : {Method::gmres, Method::source_iteration}) {
        const Problem problem = closed_box(mesh, absorption, diffuse);
        SolveOptions options = options_of(method, Acceleration::diffusion, tolerance);
        options.max_sweeps = 80;
        const Solution solution = solve(problem, directions_triangular(4), options);
        EXPECT_TRUE(solution.convergence[1].converged);
        // The radiance is emission over absorption, everywhere.
        EXPECT_LT(deviation(solution, 2, 1, 4 * M_PI), 1.5 * tolerance);
        const double error = deviation(solution, 2, 0, 4 * M_PI / absorption);
        if (solution.convergence[0].converged) {
          EXPECT_LT(error, 1.5 * tolerance) << "absorption " << absorption;
        }
        EXPECT_TRUE(absorption < 1e-8 || solution.convergence[0].converged);
      }
}

TEST(DiffusionAcceleration, SaysWhichBandHasNoSolverAndWhy) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const Problem problem = closed_box(mesh, 1e-18, 1);
  SolveOptions options = options_of(Method::gmres, Acceleration::diffusion, 1e-3);
  options.max_sweeps = 30;
  const std::vector<std::string> notes = solve(problem, directions_triangular(4), options).notes;
  const std::string wanted = "not accelerated in band " + problem.bands().names[0] + ": hardly anything";
  EXPECT_EQ(std::count_if(notes.begin(), notes.end(),
                          [&](const std::string& note) { return note.find(wanted) == 0; }),
            1);
  EXPECT_EQ(std::count_if(notes.begin(), notes.end(),
                          [](const std::string& note) { return note.find("accelerated by diffusion") == 0; }),
            1);
}

TEST(DiffusionAcceleration, ActsOnAnAbsorptionThatRoundingTakesFromTheExtinction) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 1e-10, 1e7, 1), uniform_wall(1, 0, 1, 0));
  ASSERT_EQ(1e7 + 1e-10, 1e7);
  const std::vector<double> extinction(static_cast<std::size_t>(mesh.cell_count()), 1e7);
  const DirectionSet directions = directions_triangular(4);
  TransportSweep sweep(problem, directions, extinction, tight_options());
  EXPECT_TRUE(DiffusionAcceleration(problem, sweep, extinction).acts_on(0));
}

TEST(DiffusionAcceleration, LocalCoefficientBearsAVoid) {
  const TetrahedralMesh mesh = cube_with_ball(5e-3);
  EXPECT_LE(sweeps_of(mesh, 0, 20, DiffusionLength::local), 40);
}

TEST(DiffusionAcceleration, SweepsOfABandEndWhenItIsDone) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  Medium medium = uniform_medium(2, 0.1, 20, 1);
  medium.scattering[0] = Coefficient(0.1);
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(2, 0.2, 0, 0));
  for (const Method method : {Method::gmres, Method::source_iteration})
    for (const Acceleration acceleration : {Acceleration::none, Acceleration::diffusion}) {
      SolveOptions options = options_of(method, acceleration, 1e-7);
      options.max_sweeps = 5000;
      const Solution solution = solve(problem, directions_triangular(4), options);
      ASSERT_TRUE(solution.converged());
      EXPECT_LE(solution.convergence[0].sweeps, solution.convergence[1].sweeps - 2);
      for (int band = 0; band < 2; ++band) {
        const auto entries = std::count_if(solution.history.begin(), solution.history.end(),
                                           [&](const HistoryEntry& entry) { return entry.band == band; });
        // The sweep that measures is in no history, unless it showed the true residual.
        EXPECT_EQ(entries + (method == Method::gmres ? 0 : 1),
                  solution.convergence[static_cast<std::size_t>(band)].sweeps);
      }
    }
}

TEST(DiffusionAcceleration, SourceIterationForecastsWhatIsLeft) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.1, 5, 1), uniform_wall(1, 0.2, 0.5, 0));
  int forecasts = 0;
  solve(problem, directions_triangular(4), options_of(Method::source_iteration, Acceleration::diffusion),
        [&](const SweepProgress& progress) {
          if (progress.sweep > 2 && progress.residual[0] > 10 * progress.tolerance) {
            EXPECT_GT(progress.seconds_left, 0) << "at sweep " << progress.sweep;
            ++forecasts;
          }
          return SolveControl::proceed;
        });
  EXPECT_GT(forecasts, 2);
}

TEST(DiffusionAcceleration, ServesConstantElementsToo) {
  const TetrahedralMesh mesh = cube_mesh(4e-3);
  for (const double scattering : {1.0, 100.0, 1e4}) {
    const Problem problem =
        uniform_problem(mesh, uniform_medium(1, 0, scattering, 1), uniform_wall(1, 0.2, 0.5, 0));
    SolveOptions options = options_of(Method::gmres, Acceleration::diffusion);
    options.order = SpaceOrder::constant;
    const Solution fast = solve(problem, directions_triangular(4), options);
    EXPECT_LE(fast.convergence[0].sweeps, 20) << scattering;
    options.acceleration = Acceleration::none;
    const Solution slow = solve(problem, directions_triangular(4), options);
    EXPECT_TRUE(fast.converged() && slow.converged());
    EXPECT_LT(difference(slow, fast, 1, 0), 1e-8) << scattering;
  }
}

TEST(DiffusionAcceleration, NothingHappensToABandThatIsDone) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(2, 0.1, 5, 1), uniform_wall(2, 0.2, 0.5, 0));
  const std::vector<double> extinction(static_cast<std::size_t>(2 * mesh.cell_count()), 5.1);
  const DirectionSet directions = directions_triangular(4);
  TransportSweep sweep(problem, directions, extinction, tight_options());
  DiffusionAcceleration acceleration(problem, sweep, extinction);
  TransportState zero(sweep.layout()), residual(sweep.layout()), corrected(sweep.layout());
  sweep.apply(zero, residual);
  acceleration.apply(residual, corrected, {1, 0});
  for (std::size_t i = 0; i < residual.fluence().size(); i += 2) {
    EXPECT_GT(corrected.fluence()[i], residual.fluence()[i]);
    EXPECT_EQ(corrected.fluence()[i + 1], residual.fluence()[i + 1]);
  }
}

}  // namespace
}  // namespace etendue::acceleration_test
