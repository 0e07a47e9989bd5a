// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include "solver/solution/solve_observer.h"
#include "solver/transport/order/batch_sections.h"
#include "solver/transport/solve/solve.h"
#include "tests/solver/transport/sample_problems.h"
#include "tests/support/thread_ranks.h"

namespace etendue::shared_sweep_test {
namespace {

using test::ThreadRanks;

/// A medium with a phase function between walls of all kinds, one pair of mirrors face to face.
Problem walled_medium(const TetrahedralMesh& mesh, int bands, ScatteringBackend backend) {
  Medium medium = uniform_medium(bands, 0.2, 1, 0.3, PhaseHenyeyGreenstein{0.7});
  for (std::size_t b = 1; b < medium.scattering.size(); ++b)
    medium.scattering[b] = Coefficient(1 + static_cast<double>(b));
  medium.choice.assign(static_cast<std::size_t>(bands), {backend, -1, ForwardPeak::keep});
  std::vector<Wall> walls;
  for (const std::string& name : mesh.wall_names()) {
    const bool is_mirror = name == "xmin" || name == "xmax" || name == "ymin";
    walls.push_back(uniform_wall(bands, name == "zmax" ? 1 : 0, is_mirror ? 0.1 : 0.5, is_mirror ? 0.8 : 0));
    walls.back().name = name;
  }
  Bands named;
  named.names.clear();
  for (int band = 0; band < bands; ++band) named.names.push_back(std::to_string(band));
  return Problem(mesh, named, {medium}, walls);
}

void expect_same(const Solution& a, const Solution& b) {
  EXPECT_EQ(a.fluence, b.fluence);
  EXPECT_EQ(a.net_flux, b.net_flux);
  EXPECT_EQ(a.irradiance, b.irradiance);
  EXPECT_EQ(a.exitance, b.exitance);
  ASSERT_EQ(a.radiance.size(), b.radiance.size());
  for (std::size_t i = 0; i < a.radiance.size(); ++i) EXPECT_EQ(a.radiance[i].values, b.radiance[i].values);
  ASSERT_EQ(a.fixups.size(), b.fixups.size());
  for (std::size_t i = 0; i < a.fixups.size(); ++i) {
    EXPECT_EQ(a.fixups[i].cells, b.fixups[i].cells);
    EXPECT_EQ(a.fixups[i].failed, b.fixups[i].failed);
    EXPECT_EQ(a.fixups[i].smallest, b.fixups[i].smallest);
    EXPECT_EQ(a.fixups[i].moved, b.fixups[i].moved);
  }
  for (std::size_t band = 0; band < a.convergence.size(); ++band) {
    EXPECT_EQ(a.convergence[band].sweeps, b.convergence[band].sweeps);
    EXPECT_EQ(a.convergence[band].residual, b.convergence[band].residual);
  }
  EXPECT_EQ(a.state.fluence, b.state.fluence);
  EXPECT_EQ(a.state.moments, b.state.moments);
}

/// Solves by several ranks, each with so many threads, and compares all of them with one process.
void expect_same_bits(const Problem& problem, const DirectionSet& directions, SolveOptions options) {
  options.threads = 1;
  const Solution alone = solve(problem, directions, options);
  ASSERT_TRUE(alone.converged());
  for (const auto& [ranks, threads] : {std::pair{1, 1}, {2, 1}, {3, 2}, {8, 1}, {11, 1}}) {
    options.threads = threads;
    ThreadRanks group(ranks);
    std::vector<Solution> solutions(static_cast<std::size_t>(ranks));
    group.run([&](RankGroup& own) {
      SolveOptions of_rank = options;
      of_rank.ranks = &own;
      solutions[static_cast<std::size_t>(own.rank())] = solve(problem, directions, of_rank);
    });
    for (const Solution& solution : solutions) expect_same(solution, alone);
  }
}

TEST(SharedSweep, MomentsAndMirrorsGiveTheBitsOfOneProcess) {
  const TetrahedralMesh mesh = cube_mesh(5e-2);
  SolveOptions options = tight_options(Lumping::automatic);
  options.tolerance = 1e-4;
  options.keep_ordinates = {3, 40};
  for (const Precision precision : {Precision::full, Precision::mixed}) {
    options.precision = precision;
    expect_same_bits(walled_medium(mesh, 3, ScatteringBackend::moments), directions_ldfe_sq(1), options);
  }
}

TEST(SharedSweep, MatricesGiveTheBitsOfOneProcess) {
  const TetrahedralMesh mesh = cube_mesh(4e-2);
  SolveOptions options = tight_options(Lumping::automatic);
  options.tolerance = 1e-5;
  expect_same_bits(walled_medium(mesh, 1, ScatteringBackend::dense), directions_ldfe_sq(1), options);
}

TEST(SharedSweep, PositiveSolutionsHaveTheirCensus) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  SolveOptions options = tight_options();
  options.tolerance = 1e-5;
  options.positivity = Positivity::quadratic;
  const Problem problem = uniform_problem(mesh, uniform_medium(1, 12, 3, 0), uniform_wall(1, 1, 0.3, 0));
  expect_same_bits(problem, directions_triangular(4), options);
}

TEST(SharedSweep, CoarserDirectionsAreSharedToo) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  SolveOptions options = tight_options();
  options.tolerance = 1e-6;
  const Problem problem = uniform_problem(mesh, uniform_medium(2, 0.1, 2, 1), uniform_wall(2, 0.2, 0.5, 0));
  const DirectionSet directions = directions_ldfe_sq(3);
  const Solution alone = solve(problem, directions, options);
  ASSERT_TRUE(std::ranges::any_of(
      alone.notes, [](const std::string& note) { return note.find("corrected on ") != std::string::npos; }));
  expect_same_bits(problem, directions, options);
}

TEST(SharedSweep, AllRanksStopWhereOneDoes) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = walled_medium(mesh, 1, ScatteringBackend::moments);
  ThreadRanks group(3);
  std::atomic<int> stopped = 0;
  group.run([&](RankGroup& own) {
    SolveOptions options = tight_options();
    options.ranks = &own;
    int asked = 0;
    if (own.rank() == 1) options.stops = [&] { return ++asked > 50; };
    try {
      solve(problem, directions_ldfe_sq(1), options);
    } catch (const SolveStopped&) {
      ++stopped;
    }
  });
  EXPECT_EQ(stopped, 3);
}

TEST(BatchSections, HoldAllBatchesOnce) {
  for (const int batches : {1, 3, 8, 12, 100, 1000}) {
    const BatchSections sections(batches);
    EXPECT_EQ(sections.begin(0), 0);
    EXPECT_EQ(sections.end(sections.count() - 1), batches);
    for (int s = 0; s < sections.count(); ++s) EXPECT_LT(sections.begin(s), sections.end(s));
    for (const int ranks : {1, 2, 3, 8, 11}) {
      EXPECT_EQ(sections.first_batch_of(0, ranks), 0);
      EXPECT_EQ(sections.first_batch_of(ranks, ranks), batches);
    }
  }
}

/// Leaves that the nodes of a rank cover, each once.
TEST(BatchSections, NodesOfRanksMakeTheTree) {
  const BatchSections sections(100);
  ASSERT_EQ(sections.count(), 8);
  for (const int ranks : {1, 2, 3, 5, 8, 11}) {
    int next = 0;
    for (const SumNode& node : sections.nodes(ranks)) {
      EXPECT_EQ(node.index << node.level, next);
      EXPECT_GE(next, sections.first_of(node.rank, ranks));
      next += 1 << node.level;
      EXPECT_LE(next, sections.first_of(node.rank + 1, ranks));
    }
    EXPECT_EQ(next, 8);
  }
  EXPECT_EQ(sections.nodes(2).size(), 2u);
  EXPECT_EQ(sections.nodes(3).size(), 5u);  // 0 and 1; 2 and 3, 4; 5, 6 and 7
}

}  // namespace
}  // namespace etendue::shared_sweep_test
