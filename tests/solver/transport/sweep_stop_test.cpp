// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A solution that is ended within a sweep.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "solver/solution/solve_observer.h"
#include "tests/solver/transport/sample_problems.h"

namespace etendue::sweep_stop_test {
namespace {

Problem scattering_problem(const TetrahedralMesh& mesh) {
  return uniform_problem(mesh, uniform_medium(1, 0.1, 2, 0.2), uniform_wall(1, 0.3, 0.5, 0));
}

/// Solves, and stops within the sweep after `whole` ones.
SavedState stopped_after(int whole, const Problem& problem, const DirectionSet& directions,
                         SolveOptions options) {
  std::atomic<int> sweeps = 0, asked = 0;
  // Not at the first time that the sweep asks, but in its midst.
  options.stops = [&] { return sweeps >= whole && ++asked > 2; };
  try {
    solve(problem, directions, options, [&](const SweepProgress& progress) {
      sweeps = progress.sweep;
      return SolveControl::proceed;
    });
  } catch (const SolveStopped& stopped) {
    EXPECT_EQ(sweeps, whole);
    return stopped.state;
  }
  ADD_FAILURE() << "the solution was not stopped";
  return {};
}

class SweepStop : public testing::TestWithParam<Method> {};

TEST_P(SweepStop, LeavesTheStateOfTheLastWholeSweepToGoOnFrom) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = scattering_problem(mesh);
  const DirectionSet directions = directions_product(4);
  SolveOptions options = tight_options();
  options.method = GetParam();
  options.acceleration = Acceleration::none;
  options.threads = 2;
  const Solution whole = solve(problem, directions, options);
  const SavedState state = stopped_after(4, problem, directions, options);
  ASSERT_EQ(state.fluence.size(), whole.state.fluence.size());
  // Four sweeps have come closer than darkness is, and are not all.
  EXPECT_LT(relative_difference(state.fluence, whole.state.fluence), 0.5);
  EXPECT_GT(relative_difference(state.fluence, whole.state.fluence), options.tolerance);
  options.initial = &state;
  EXPECT_LT(relative_difference(solve(problem, directions, options).fluence, whole.fluence),
            100 * options.tolerance);
}

// It stops in the sweeps on fewer directions that come before the fourth on all.
TEST(SweepStopInACorrection, LeavesTheStateOfTheLastWholeSweepToGoOnFrom) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = scattering_problem(mesh);
  SolveOptions options = tight_options();
  options.threads = 2;
  const Solution whole = solve(problem, directions_ldfe_sq(3), options);
  const SavedState state = stopped_after(3, problem, directions_ldfe_sq(3), options);
  EXPECT_LT(relative_difference(state.fluence, whole.state.fluence), 0.1);
  EXPECT_GT(relative_difference(state.fluence, whole.state.fluence), options.tolerance);
  options.initial = &state;
  EXPECT_LT(relative_difference(solve(problem, directions_ldfe_sq(3), options).fluence, whole.fluence),
            100 * options.tolerance);
}

INSTANTIATE_TEST_SUITE_P(Methods, SweepStop, testing::Values(Method::gmres, Method::source_iteration));

// A black absorbing cube takes one sweep.
TEST(SweepShare, RisesToOneInASweep) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 1, 0, 0.2), uniform_wall(1, 0.3, 0, 0));
  SolveOptions options;
  options.threads = 2;
  std::vector<double> shares, made;
  options.sweep_share = [&](double share) { shares.push_back(share); };
  options.orders_share = [&](double share) {
    EXPECT_TRUE(shares.empty());
    made.push_back(share);
  };
  ASSERT_EQ(solve(problem, directions_product(8), options).convergence.at(0).sweeps, 1);
  ASSERT_EQ(made.size(), static_cast<std::size_t>(directions_product(8).count() / 2));
  EXPECT_TRUE(std::ranges::is_sorted(made));
  EXPECT_EQ(made.back(), 1);
  ASSERT_GT(shares.size(), 1u);
  EXPECT_GT(shares.front(), 0);
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_EQ(shares.back(), 1);
}

TEST(SolveStopped, EndsTheSweepThatMeasures) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = scattering_problem(mesh);
  const DirectionSet directions = directions_product(2);
  SolveOptions options = tight_options();
  options.max_sweeps = 1;  // none but the one that measures
  options.stops = [] { return true; };
  EXPECT_THROW(solve(problem, directions, options), SolveStopped);
}

}  // namespace
}  // namespace etendue::sweep_stop_test
