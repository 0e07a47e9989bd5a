// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/observe/photon_map/keep_hits.h"

#include <gtest/gtest.h>

#include <cstring>
#include <numbers>

#include "tests/solver/transport/sample_problems.h"

namespace etendue::keep_hits_test {
namespace {

/// Grey walls that shine, and haze.
Problem haze(const TetrahedralMesh& mesh) {
  return uniform_problem(mesh, uniform_medium(1, 0.2, 1.5, 0), uniform_wall(1, 1, 0.5, 0));
}

TEST(KeepHits, HasTheSameBitsForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = haze(mesh);
  const CellLocator locator(mesh);
  PhotonMapOptions options{20000, 1e6, 50, 1, 1};
  const std::vector<BandHits> one = keep_hits(problem, locator, options);
  options.threads = 2;
  const std::vector<BandHits> two = keep_hits(problem, locator, options);
  for (const auto part : {&BandHits::walls, &BandHits::matter}) {
    const KeptHits &a = one[0].*part, &b = two[0].*part;
    ASSERT_EQ(a.hits.size(), b.hits.size());
    EXPECT_EQ(std::memcmp(a.hits.data(), b.hits.data(), a.hits.size() * sizeof(PhotonHit)), 0);
    EXPECT_EQ(a.power, b.power);
  }
}

TEST(KeepHits, KeepsNoMoreThanWantedAndCountsTheirHistories) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem = haze(mesh);
  const CellLocator locator(mesh);
  const BandHits all = keep_hits(problem, locator, {60000, 1e6, 50, 1, 2})[0];
  const BandHits few = keep_hits(problem, locator, {60000, 40000, 50, 1, 2})[0];
  EXPECT_EQ(all.walls.histories, 60000);
  for (const auto part : {&BandHits::walls, &BandHits::matter}) {
    EXPECT_LE((few.*part).hits.size(), 40000u);
    EXPECT_LT((few.*part).histories, 60000);
    EXPECT_NEAR((few.*part).power * (few.*part).histories, (all.*part).power * (all.*part).histories, 1e-9);
  }
}

// Walls of radiance 1 send pi on each of the 6 sides; in a furnace they receive as much.
TEST(KeepHits, BringThePowerThatArrives) {
  const TetrahedralMesh mesh = cube_mesh(0.02);
  const Problem problem =
      uniform_problem(mesh, uniform_medium(1, 0.5, 1.5, 0.5), uniform_wall(1, 0.5, 0.5, 0));
  const BandHits hits = keep_hits(problem, CellLocator(mesh), {60000, 1e6, 50, 1, 2})[0];
  const auto sum = [](const KeptHits& kept) {
    double weight = 0;
    for (const PhotonHit& hit : kept.hits) weight += hit.weight;
    return weight * kept.power;
  };
  EXPECT_NEAR(sum(hits.walls), 6 * std::numbers::pi, 0.01 * 6 * std::numbers::pi);
  EXPECT_NEAR(sum(hits.matter), 1.5 * 4 * std::numbers::pi, 0.01 * 6 * std::numbers::pi);
}

}  // namespace
}  // namespace etendue::keep_hits_test
