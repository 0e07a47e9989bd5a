// SPDX-License-Identifier: AGPL-3.0-or-later
//
// An iteration that starts where another one stood.
#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.h"
#include "solver/solution/saved_state.h"
#include "solver/solution/solve_observer.h"
#include "solver/transport/state/state_copy.h"
#include "solver/transport/state/transport_state.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::restart_test {
namespace {

/// Three bands, so that lanes are padded; every part of the state is there but lagged faces.
Problem sample_problem(const TetrahedralMesh& mesh) {
  Medium medium = uniform_medium(3, 0.1, 0, 0.2, PhaseHenyeyGreenstein{0.5});
  medium.scattering = {Coefficient(0.5), Coefficient(3.0), Coefficient(8.0)};
  return uniform_problem(mesh, medium, uniform_wall(3, 0.3, 0.5, 0.2));
}

SolveOptions options_of(Method method, double tolerance) {
  SolveOptions options = tight_options();
  options.method = method;
  options.tolerance = tolerance;
  return options;
}

/// Of the fluence in L2, relative, over all bands.
double difference(const Solution& a, const Solution& b) {
  double error = 0, norm = 0;
  for (std::size_t i = 0; i < a.fluence.size(); ++i) {
    error += std::pow(a.fluence[i] - b.fluence[i], 2);
    norm += std::pow(b.fluence[i], 2);
  }
  return std::sqrt(error / norm);
}

void expect_same(const SavedState& a, const SavedState& b) {
  EXPECT_EQ(a.bands, b.bands);
  EXPECT_EQ(a.fluence, b.fluence);
  EXPECT_EQ(a.moments, b.moments);
  EXPECT_EQ(a.irradiance, b.irradiance);
  EXPECT_EQ(a.mirrors, b.mirrors);
  EXPECT_EQ(a.lagged, b.lagged);
}

TEST(SavedState, IsRestoredToTheLastBit) {
  TransportState state({12 * 4, 8 * 4, 9 * 4, 6 * 4, 3 * 4});
  for (std::size_t i = 0; i < state.values().size(); ++i)
    state.values()[i] = i % 4 == 3 ? 0 : std::exp(static_cast<double>(i)) / 3;
  TransportState copy(state.layout());
  const SavedState values = saved(state, 3);
  EXPECT_EQ(values.fluence.size(), 36u);
  restore(values, 3, copy);
  EXPECT_TRUE(std::equal(state.values().begin(), state.values().end(), copy.values().begin()));
  expect_same(saved(copy, 3), values);
}

TEST(SavedState, OfAnotherKindIsRefused) {
  const SavedState values = saved(TransportState({12, 0, 0, 9, 0, 0}), 1);
  TransportState other({12, 6, 9, 0, 0});
  EXPECT_THROW(restore(values, 1, other), InputError);
  EXPECT_THROW(restore(values, 2, other), InputError);
  SavedState longer = saved(TransportState({12 * 4, 0, 0, 9 * 4, 0, 0}), 3);
  longer.fluence.push_back(1);  // a part of a row
  TransportState same({12 * 4, 0, 0, 9 * 4, 0, 0});
  EXPECT_THROW(restore(longer, 3, same), InputError);
}

TEST(Restart, FromTheSolutionEndsAtOnce) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = sample_problem(mesh);
  const DirectionSet directions = directions_triangular(4);
  for (const Method method : {Method::gmres, Method::source_iteration}) {
    SolveOptions options = options_of(method, 1e-7);
    const Solution first = solve(problem, directions, options);
    ASSERT_TRUE(first.converged());
    options.initial = &first.state;
    const Solution again = solve(problem, directions, options);
    ASSERT_TRUE(again.converged());
    EXPECT_LE(again.convergence[2].sweeps, 4);
    EXPECT_LT(difference(again, first), 1e-7);
  }
}

TEST(Restart, FromAnySweepReachesTheSameAnswer) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = sample_problem(mesh);
  const DirectionSet directions = directions_triangular(4);
  const Solution exact = solve(problem, directions, options_of(Method::gmres, 1e-12));
  for (const Method method : {Method::gmres, Method::source_iteration}) {
    const Solution uninterrupted = solve(problem, directions, options_of(method, 1e-8));
    for (const int last : {1, 2, 5, 9}) {
      SCOPED_TRACE(testing::Message() << uninterrupted.method << " stopped after sweep " << last);
      SavedState checkpoint;
      const Solution interrupted =
          solve(problem, directions, options_of(method, 1e-8), [&](const SweepProgress& progress) {
            if (progress.sweep < last) return SolveControl::proceed;
            checkpoint = progress.state();
            return SolveControl::stop;
          });
      ASSERT_TRUE(interrupted.interrupted);
      SolveOptions options = options_of(method, 1e-8);
      options.initial = &checkpoint;
      const Solution continued = solve(problem, directions, options);
      ASSERT_TRUE(continued.converged());
      EXPECT_LT(difference(continued, exact), 1e-8);
      EXPECT_LT(difference(continued, uninterrupted), 2e-8);
    }
  }
}

TEST(Restart, KeepsWhatTheInterruptedIterationHasGained) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = sample_problem(mesh);
  const DirectionSet directions = directions_triangular(4);
  const Solution exact = solve(problem, directions, options_of(Method::gmres, 1e-12));
  SolveOptions options = options_of(Method::gmres, 1e-12);
  options.max_sweeps = 12;
  const Solution stopped = solve(problem, directions, options);
  options.initial = &stopped.state;
  options.max_sweeps = 1;  // F of where it starts
  EXPECT_LE(difference(solve(problem, directions, options), exact), difference(stopped, exact));
}

}  // namespace
}  // namespace etendue::restart_test
