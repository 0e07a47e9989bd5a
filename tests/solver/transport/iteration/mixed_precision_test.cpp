// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>

#include "base/errors.h"
#include "solver/materials/surfaces/phong.h"
#include "solver/solution/balance.h"
#include "solver/transport/iteration/residual.h"
#include "solver/transport/state/state_copy.h"
#include "solver/transport/sweep/transport_sweep.h"
#include "tests/mesh/tetrahedra/sample_meshes.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::mixed_precision_test {
namespace {

/// A problem and its sweeps in both precisions.
struct BothSweeps {
  BothSweeps(const Problem& problem, const DirectionSet& directions)
      : extinction(extinction_of(problem)),
        full(problem, directions, extinction, tight_options(Lumping::automatic)),
        single(full) {}

  std::vector<double> extinction;
  TransportSweep full;
  SingleTransportSweep single;
};

/// Values between 0 and 2 times `size`.
TransportState some_state(const StateLayout& layout, double size = 1) {
  TransportState state(layout);
  for (std::size_t i = 0; i < state.values().size(); ++i)
    state.values()[i] = size * (1 + std::sin(static_cast<double>(i * i % 1013)));
  return state;
}

/// Of one linear sweep in single precision, against double.
double error_of_single(const Problem& problem, const DirectionSet& directions) {
  BothSweeps sweeps(problem, directions);
  const TransportState last = some_state(sweeps.full.layout());
  TransportState full(sweeps.full.layout()), single(sweeps.full.layout());
  sweeps.full.apply_linear(last, full);
  sweeps.single.apply_linear(last, single);
  return relative_difference(single.values(), full.values());
}

/// Rounding errors of a sweep with floats, which in part cancel, beside that of one operation.
constexpr double single_rounding = 5 * std::numeric_limits<float>::epsilon();

TEST(SingleTransportSweep, IsThatOfDoubleToSinglePrecision) {
  const TetrahedralMesh mesh = cube_with_ball(5e-3);
  for (const int bands : {1, 2, 3, 8, 11, 16, 24})
    for (const double asymmetry : {0.0, 0.5}) {
      Medium medium = uniform_medium(bands, 9, 3.8, 0.7);
      if (asymmetry > 0) {
        medium.phase.assign(static_cast<std::size_t>(bands), PhaseHenyeyGreenstein{asymmetry});
        medium.choice.assign(static_cast<std::size_t>(bands), {ScatteringBackend::moments, 3});
      }
      // Some cells are lumped.
      const Problem problem = uniform_problem(mesh, medium, uniform_wall(bands, 0.2, 0.3, 0.4));
      EXPECT_LT(error_of_single(problem, directions_product(4)), single_rounding)
          << bands << " bands, asymmetry " << asymmetry;
    }
}

TEST(SingleTransportSweep, ScattersByMatrices) {
  const TetrahedralMesh mesh = cube_with_ball(5e-3);
  Medium medium = uniform_medium(2, 1, 3, 0.7, PhaseHenyeyGreenstein{0.8});
  medium.choice.assign(2, {ScatteringBackend::dense});
  const Problem problem = uniform_problem(mesh, medium, uniform_wall(2, 0.2, 0.3, 0));
  EXPECT_LT(error_of_single(problem, directions_ldfe_sq(1)), single_rounding);
}

TEST(SingleTransportSweep, DoesNotMindTheUnitOfLength) {
  // Products of four areas of these cells are far out of the range of floats.
  for (const double length : {1e-9, 1e9}) {
    const TetrahedralMesh mesh = moved_mesh(cube_mesh(2e-2), [&](const Vec3& x) { return length * x; });
    const Problem problem =
        uniform_problem(mesh, uniform_medium(1, 2 / length, 1 / length, 0.7), uniform_wall(1, 0.2, 0.3, 0.4));
    EXPECT_LT(error_of_single(problem, directions_product(4)), single_rounding) << length;
  }
}

TEST(SingleTransportSweep, InstructionSetsGiveTheSameBits) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  for (const int bands : {1, 2, 3, 8, 11, 16, 24}) {
    Medium medium = uniform_medium(bands, 1.3, 0.9, 0.7, PhaseHenyeyGreenstein{0.4});
    medium.choice.assign(static_cast<std::size_t>(bands), {ScatteringBackend::moments, 3});
    const Problem problem = uniform_problem(mesh, medium, uniform_wall(bands, 0.2, 0.3, 0.1));
    const DirectionSet directions = directions_product(4);
    std::vector<double> baseline;
    for (const char* isa : {"baseline", "avx2", "avx512"}) {
      setenv("ETENDUE_ISA", isa, 1);
      try {
        BothSweeps sweeps(problem, directions);
        TransportState next(sweeps.full.layout());
        sweeps.single.apply_linear(some_state(sweeps.full.layout()), next);
        const std::vector<double> values(next.values().begin(), next.values().end());
        if (baseline.empty()) baseline = values;
        EXPECT_EQ(values, baseline) << isa << " with " << bands << " bands";
      } catch (const InputError&) {
        continue;
      }
    }
    unsetenv("ETENDUE_ISA");
  }
}

TEST(SingleTransportSweep, LeavesNoNumbersWithoutPrecision) {
  // Forty mean free paths through thin cells bring light of the smallest floats to nothing.
  const TetrahedralMesh mesh = cube_mesh(1e-3);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 40, 0, 0), uniform_wall(1, 1, 0.5, 0));
  const DirectionSet directions = directions_product(4);
  BothSweeps sweeps(problem, directions);
  TransportState next(sweeps.full.layout());
  sweeps.single.apply_linear(some_state(sweeps.full.layout(), 1e-30), next);
  EXPECT_GT(*std::max_element(next.fluence().begin(), next.fluence().end()), 0);
  for (const double value : next.fluence())
    EXPECT_TRUE(value == 0 || std::abs(value) >= static_cast<double>(std::numeric_limits<float>::min()))
        << value;
}

struct Named {
  const char* name;
  Problem problem;
  DirectionSet directions;
};

/// Walls across z are mirrors, as they have to be in the plane.
Problem plane_problem(const TetrahedralMesh& mesh, const Medium& medium, const Wall& wall) {
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    walls.push_back(name[0] == 'z' ? uniform_wall(1, 0, 0, 1) : wall);
    walls.back().name = name;
  }
  return Problem(mesh, Bands{}, {medium}, walls, AngularSpace::plane);
}

/// What sweeps, walls and media can have.
std::vector<Named> varied_problems(const TetrahedralMesh& mesh) {
  Medium forward = uniform_medium(3, 0.1, 0, 0.2, PhaseHenyeyGreenstein{0.5});
  forward.scattering = {Coefficient(0.5), Coefficient(3.0), Coefficient(8.0)};
  forward.choice.assign(3, {ScatteringBackend::moments, 3});
  Medium matrix = uniform_medium(1, 0.2, 2, 1, PhaseHenyeyGreenstein{0.8});
  matrix.choice.assign(1, {ScatteringBackend::dense});
  std::vector<Named> problems;
  problems.push_back({"moments, mirrors, bands apart",
                      uniform_problem(mesh, forward, uniform_wall(3, 0.3, 0.5, 0.2)),
                      directions_triangular(4)});
  problems.push_back(
      {"matrix", uniform_problem(mesh, matrix, uniform_wall(1, 0.3, 0.4, 0)), directions_ldfe_sq(1)});
  problems.push_back({"void", uniform_problem(mesh, uniform_medium(2, 0, 0, 0), uniform_wall(2, 1, 0.7, 0)),
                      directions_triangular(4)});
  problems.push_back({"thick and bright",
                      uniform_problem(mesh, uniform_medium(1, 0.001, 50, 1), uniform_wall(1, 0, 0, 0)),
                      directions_triangular(4)});
  Medium leaves = uniform_medium(1, 0.1, 2, 0.5);
  leaves.directional = {LeafCanopy{LeafAngles::horizontal, 0.6, 0.3}};
  problems.push_back(
      {"leaves", uniform_problem(mesh, leaves, uniform_wall(1, 0.3, 0.4, 0)), directions_ldfe_sq(1)});
  Medium flame = uniform_medium(1, 0.5, 1, 0, PhaseHenyeyGreenstein{0.5});
  flame.emission_by_direction = {AngularFormula("1 + 0.5*wz")};
  Wall polished = uniform_wall(1, 0.3, 0.1, 0);
  polished.glossy = {std::make_shared<Phong>(0.7, 20)};
  problems.push_back(
      {"glossy walls, emission by direction", uniform_problem(mesh, flame, polished), directions_ldfe_sq(1)});
  problems.push_back({"plane",
                      plane_problem(mesh, uniform_medium(1, 0.1, 3, 1, PhaseHenyeyGreenstein{0.6}),
                                    uniform_wall(1, 0.2, 0.5, 0)),
                      directions_flatland(16)});
  return problems;
}

TEST(MixedPrecision, GivesTheSolutionOfDouble) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  for (const Named& sample : varied_problems(mesh))
    for (const Acceleration acceleration : {Acceleration::none, Acceleration::diffusion}) {
      SolveOptions options = tight_options(Lumping::automatic);
      options.acceleration = acceleration;
      options.method = Method::gmres;
      options.tolerance = 1e-11;
      options.precision = Precision::full;
      const Solution full = solve(sample.problem, sample.directions, options);
      options.precision = Precision::mixed;
      const Solution mixed = solve(sample.problem, sample.directions, options);
      ASSERT_TRUE(full.converged()) << sample.name;
      ASSERT_TRUE(mixed.converged()) << sample.name;
      const int bands = sample.problem.band_count();
      for (int band = 0; band < bands; ++band)
        EXPECT_LT(difference(mixed, full, static_cast<std::size_t>(bands), static_cast<std::size_t>(band)),
                  2 * options.tolerance)
            << sample.name;
      // Restarts where floats end cost some sweeps, never many.
      EXPECT_LT(mixed.convergence[0].sweeps, 2 * full.convergence[0].sweeps) << sample.name;
      for (const Balance& balance : balances(sample.problem, mixed))
        EXPECT_LT(std::abs(balance.residual), 1e-9) << sample.name;
    }
}

TEST(MixedPrecision, ResidualInDoubleIsBelowTheTolerance) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem =
      uniform_problem(mesh, uniform_medium(1, 0.05, 5, 1), uniform_wall(1, 0.2, 0.6, 0.1));
  const DirectionSet directions = directions_triangular(4);
  const std::vector<double> extinction(static_cast<std::size_t>(mesh.cell_count()), 5.05);
  for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
    SolveOptions options = tight_options();
    options.method = Method::gmres;
    options.precision = Precision::mixed;
    options.tolerance = tolerance;
    const Solution solution = solve(problem, directions, options);
    ASSERT_TRUE(solution.converged());
    TransportSweep sweep(problem, directions, extinction, options);
    TransportState last(sweep.layout()), next(sweep.layout());
    restore(solution.state, 1, last);
    sweep.apply(last, next);
    EXPECT_LT(relative_residual(mesh, sweep, last, next)[0], tolerance);
  }
}

TEST(MixedPrecision, IsTakenWhereTheToleranceAllows) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.1, 2, 1), uniform_wall(1, 0.2, 0.5, 0.1));
  SolveOptions options = tight_options();
  options.method = Method::gmres;
  const auto fluence = [&](Precision precision, double tolerance) {
    options.precision = precision;
    options.tolerance = tolerance;
    return solve(problem, directions_ldfe_sq(1), options).fluence;
  };
  EXPECT_EQ(fluence(Precision::automatic, 1e-10), fluence(Precision::mixed, 1e-10));
  EXPECT_NE(fluence(Precision::automatic, 1e-10), fluence(Precision::full, 1e-10));
  EXPECT_EQ(fluence(Precision::automatic, 9e-11), fluence(Precision::full, 9e-11));
  options.method = Method::source_iteration;
  EXPECT_EQ(fluence(Precision::automatic, 1e-6), fluence(Precision::full, 1e-6));
}

// Cells of 1000 free paths: an error is a million times its residual.
TEST(MixedPrecision, GoesOnInDoubleWhereLightReturnsTooOften) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0, 4e3, 1), uniform_wall(1, 0, 0, 0));
  SolveOptions options;
  options.method = Method::gmres;
  options.precision = Precision::full;
  const Solution full = solve(problem, directions_triangular(4), options);
  options.precision = Precision::automatic;
  EXPECT_EQ(solve(problem, directions_triangular(4), options).fluence, full.fluence);
  options.precision = Precision::mixed;
  const Solution mixed = solve(problem, directions_triangular(4), options);
  ASSERT_TRUE(mixed.converged());
  EXPECT_LT(difference(mixed, full, 1, 0), 3 * options.tolerance);
  EXPECT_TRUE(std::ranges::any_of(mixed.notes, [](const std::string& note) {
    return note.find("single precision does not suffice: double from sweep ") != std::string::npos;
  }));
}

TEST(MixedPrecision, KeepsValuesPositiveInDouble) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 12, 3, 0), uniform_wall(1, 1, 0.3, 0));
  SolveOptions options = tight_options();
  options.method = Method::gmres;
  options.positivity = Positivity::quadratic;
  options.tolerance = 1e-9;
  options.precision = Precision::full;
  const Solution full = solve(problem, directions_triangular(4), options);
  options.precision = Precision::mixed;
  const Solution mixed = solve(problem, directions_triangular(4), options);
  ASSERT_TRUE(mixed.converged());
  for (const double value : mixed.fluence) EXPECT_GE(value, 0);
  EXPECT_LT(difference(mixed, full, 1, 0), 1e-8);
}

TEST(MixedPrecision, SameBitsForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = cube_mesh(1e-2);
  const Problem problem = uniform_problem(mesh, uniform_medium(2, 0.1, 2, 1), uniform_wall(2, 0.2, 0.5, 0.1));
  SolveOptions options = tight_options();
  options.precision = Precision::mixed;
  options.tolerance = 1e-8;
  options.threads = 1;
  const Solution one = solve(problem, directions_ldfe_sq(1), options);
  for (const int threads : {2, 3}) {
    options.threads = threads;
    EXPECT_EQ(solve(problem, directions_ldfe_sq(1), options).fluence, one.fluence);
  }
}

TEST(MixedPrecision, BreaksCyclesAsDoubleDoes) {
  // A ring of cells about the direction of an ordinate.
  const DirectionSet directions = directions_product(4);
  const TetrahedralMesh mesh = cyclic_ring_about(directions.direction(OrdinateIndex(0)));
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 0.3, 2, 1), uniform_wall(1, 0.2, 0.3, 0));
  SolveOptions options = tight_options();
  options.tolerance = 1e-10;
  options.precision = Precision::full;
  const Solution full = solve(problem, directions, options);
  options.precision = Precision::mixed;
  const Solution mixed = solve(problem, directions, options);
  ASSERT_GT(full.lagged_faces, 0);
  ASSERT_TRUE(mixed.converged());
  EXPECT_LT(difference(mixed, full, 1, 0), 1e-9);
}

}  // namespace
}  // namespace etendue::mixed_precision_test
