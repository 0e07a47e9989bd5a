// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <vector>

#include "solver/photons/solve/solve_photons.h"
#include "tests/solver/transport/sample_problems.h"
#include "tests/support/thread_ranks.h"

namespace etendue::shared_histories_test {
namespace {

using test::ThreadRanks;

Problem hazy_room(const TetrahedralMesh& mesh) {
  Medium medium = uniform_medium(2, 0.3, 2, 0.5, PhaseHenyeyGreenstein{0.6});
  medium.absorption[1] = Coefficient(1.5);
  return uniform_problem(mesh, medium, uniform_wall(2, 1, 0.4, 0.3));
}

/// What each of so many ranks finds.
std::vector<PhotonSolution> found(const Problem& problem, PhotonOptions options, int ranks,
                                  const PhotonObserver& of_last = {}) {
  const CellLocator locator(problem.mesh());
  ThreadRanks group(ranks);
  std::vector<PhotonSolution> solutions(static_cast<std::size_t>(ranks));
  group.run([&](RankGroup& own) {
    PhotonOptions of_rank = options;
    of_rank.ranks = &own;
    solutions[static_cast<std::size_t>(own.rank())] =
        solve_photons(problem, locator, of_rank, own.rank() == ranks - 1 ? of_last : PhotonObserver());
  });
  return solutions;
}

TEST(SharedHistories, GiveTheBitsOfOneProcess) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = hazy_room(mesh);
  for (const double until : {0.0, 0.05}) {
    PhotonOptions options{.photons = 1e5, .until = until, .threads = 2};
    const PhotonSolution alone = solve_photons(problem, CellLocator(mesh), options, {}, {});
    for (const int ranks : {1, 2, 3, 5}) {
      options.threads = ranks == 2 ? 2 : 1;
      for (const PhotonSolution& shared : found(problem, options, ranks)) {
        EXPECT_EQ(shared.solution.fluence, alone.solution.fluence);
        EXPECT_EQ(shared.solution.net_flux, alone.solution.net_flux);
        EXPECT_EQ(shared.solution.irradiance, alone.solution.irradiance);
        EXPECT_EQ(shared.solution.exitance, alone.solution.exitance);
        EXPECT_EQ(shared.solution.state.photons, alone.solution.state.photons);
        EXPECT_EQ(shared.report.error, alone.report.error);
        EXPECT_EQ(shared.report.segments, alone.report.segments);
      }
    }
  }
}

TEST(SharedHistories, EndTogetherWhereOneRankStops) {
  const TetrahedralMesh mesh = cube_mesh(2e-2);
  const Problem problem = hazy_room(mesh);
  const std::vector<PhotonSolution> solutions =
      found(problem, {.photons = 1e6, .threads = 1}, 3, [](const PhotonProgress& progress) {
        return progress.batches > 5 ? SolveControl::stop : SolveControl::proceed;
      });
  for (const PhotonSolution& solution : solutions) {
    EXPECT_TRUE(solution.solution.interrupted);
    EXPECT_EQ(solution.sums.histories, solutions[0].sums.histories);
    EXPECT_EQ(solution.solution.fluence, solutions[0].solution.fluence);
  }
  EXPECT_GT(solutions[0].sums.histories, 0u);
  EXPECT_LT(static_cast<double>(solutions[0].sums.histories), 1e6);
}

}  // namespace
}  // namespace etendue::shared_histories_test
