// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/exchange/exchange_links.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/solver/radiosity/radiosity_samples.h"
#include "tests/solver/radiosity/reference_shapes.h"

namespace etendue::exchange_links_test {
namespace {

LinkRule rule_for(const std::vector<FlatPatch>& patches, double tolerance) {
  return {tolerance, std::vector<double>(patches.size(), 1)};
}

TEST(ExchangeLinks, AreSymmetricAndCloseWithoutLosingThat) {
  const std::vector<FlatPatch> patches = wall_patches(cube_mesh(0.05), 0.3).patches;
  ExchangeLinks links(patches, rule_for(patches, 1e-3), 1, 1);
  EXPECT_GT(links.row_sums().largest, 1e-4);
  EXPECT_LT(links.row_sums().largest, 0.05);
  links.close(1e-12);
  EXPECT_LT(links.row_sums().largest, 1e-11);
  std::vector<std::vector<double>> rows;
  for (std::size_t j = 0; j < patches.size(); ++j) rows.push_back(links.row(j));
  for (std::size_t j = 0; j < patches.size(); ++j)
    for (std::size_t k = 0; k < patches.size(); ++k) EXPECT_NEAR(rows[j][k], rows[k][j], 1e-15);
}

// Small areas of a sphere: the kernel is the same between all, so whole parts of it are linked.
TEST(ExchangeLinks, NeedFewBetweenManyFacesOfASphere) {
  std::vector<FlatPatch> patches;
  for (const TriangleCorners& t : turned(sphere_triangles(1, 10))) patches.emplace_back(std::vector{t});
  ExchangeLinks links(patches, rule_for(patches, 1e-3), 1, 2);
  EXPECT_LT(links.link_count(), 30 * patches.size());
  links.close(1e-12);
  double area = 0;
  std::vector<double> height;
  for (const FlatPatch& patch : patches) {
    area += patch.area();
    height.push_back(patch.centroid()[2] > 0 ? 2 : 0);
  }
  const std::vector<double> arrived = links.times(height, 1);
  for (std::size_t j = 0; j < patches.size(); ++j) EXPECT_NEAR(arrived[j] / patches[j].area(), 1, 0.02);
}

TEST(ExchangeLinks, HaveTheSameBitsForAnyNumberOfThreads) {
  const std::vector<FlatPatch> patches = wall_patches(room_with_crate(0.1), 0.6).patches;
  const ExchangeLinks one(patches, rule_for(patches, 1e-3), 4, 1),
      three(patches, rule_for(patches, 1e-3), 4, 3);
  EXPECT_EQ(one.link_count(), three.link_count());
  const std::vector<double> even(patches.size(), 1);
  EXPECT_EQ(one.times(even, 1), three.times(even, 1));
}

// Links that were found for little light are split for more as if they had been found for that: the same
// ones, after which all stay.
TEST(ExchangeLinks, AreSplitWhereMoreIsSentUntilAllStay) {
  for (const TetrahedralMesh& mesh : {cube_mesh(0.05), room_with_crate(0.1)}) {
    const std::vector<FlatPatch> patches = wall_patches(mesh, 0.25).patches;
    std::vector<double> bright(patches.size(), 1);
    for (std::size_t p = 0; p < patches.size(); ++p)
      if (patches[p].centroid().norm() < 0.5) bright[p] = 30;
    ExchangeLinks links(patches, rule_for(patches, 2e-3), 4, 2);
    EXPECT_EQ(links.refine(std::vector<double>(patches.size(), 1)), 0u);
    const std::size_t before = links.link_count();
    links.close(1e-12);
    EXPECT_GT(links.refine(bright), 0u);
    EXPECT_EQ(links.refine(bright), 0u);
    EXPECT_GT(links.link_count(), before);
    const ExchangeLinks anew(patches, {2e-3, bright}, 4, 2);
    EXPECT_EQ(links.link_count(), anew.link_count());
    const std::vector<double> found = links.times(bright, 1), wanted = anew.times(bright, 1);
    for (std::size_t p = 0; p < patches.size(); ++p) EXPECT_NEAR(found[p], wanted[p], 1e-12 * wanted[p]);
  }
}

TEST(ExchangeLinks, TellHowFarTheyAre) {
  const std::vector<FlatPatch> patches = wall_patches(cube_mesh(0.05), 0.3).patches;
  double last = 0;
  const ExchangeLinks links(patches, rule_for(patches, 1e-3), 1, 1, [&](double done) {
    EXPECT_GE(done, last);
    last = done;
  });
  EXPECT_NEAR(last, 1, 1e-9);
}

}  // namespace
}  // namespace etendue::exchange_links_test
